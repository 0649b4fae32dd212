// Everything that the page points at is an index into what it is drawn from:
// rules and symbols by their spans in the text, insertions by number, parts of
// the robot by the symbol that made them. So the page itself knows no grammar;
// what is not linked here cannot be highlighted there.

#include "runtime/history/explain_json.h"

#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "compiler/print.h"
#include "compiler/truth.h"
#include "runtime/compare/body_difference.h"
#include "runtime/develop/part_names.h"
#include "runtime/develop/provenance.h"
#include "runtime/history/history_json.h"
#include "runtime/pictures/svg_style.h"
#include "runtime/text/json_dump.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

Json SpanJson(Span span) {
  return {span.begin, span.end};
}

// What is the same in all environments.
Json GenotypeRuleJson(const ExplainedRobot& robot, std::size_t index) {
  const Genotype& genotype = robot.genotype;
  const Rule& rule = genotype.rules[index];
  const RuleSpans& spans = robot.map.rules[index];
  Json terms = Json::array();
  for (const Term& term : rule.clause.terms)
    terms.push_back(PrintClause({{term}, {}}, genotype));
  Json connectives = Json::array();
  for (const Connective connective : rule.clause.connectives)
    connectives.push_back(connective == Connective::kAnd ? "and" : "or");
  Json symbols = Json::array();
  for (std::size_t i = 0; i < rule.production.size(); ++i)
    symbols.push_back(
        {{"text", PrintSymbol(rule.production[i], *genotype.alphabet)},
         {"name", genotype.SymbolOf(rule.production[i].id).name},
         {"span", SpanJson(spans.symbols[i])}});
  return {{"head", genotype.SymbolOf(rule.head).name},
          {"line", robot.source.PositionOf(spans.rule.begin).line},
          {"span", SpanJson(spans.rule)},
          {"terms", std::move(terms)},
          {"connectives", std::move(connectives)},
          {"symbols", std::move(symbols)}};
}

// By rule: whether it is active, and which of its terms hold.
Json RegulationJson(const Genotype& genotype, const Environment& environment) {
  Json rules = Json::array();
  for (const Rule& rule : genotype.rules) {
    Json terms = Json::array();
    for (const Term& term : rule.clause.terms)
      terms.push_back(ClauseHolds(Clause{{term}, {}}, environment.values));
    rules.push_back({{"active", ClauseHolds(rule.clause, environment.values)},
                     {"terms", std::move(terms)}});
  }
  return rules;
}

// [rule, position, iteration, parent] an insertion, 0 where there is none.
// Arrays, as there may be tens of thousands.
Json InsertionsJson(const Derivation& derivation) {
  Json all = Json::array();
  for (const Insertion& one : derivation.insertions) {
    const bool is_axiom = one.occurrence.rule == kNoRule;
    all.push_back({is_axiom ? 0 : one.occurrence.rule + 1,
                   is_axiom ? 0 : one.occurrence.position + 1, one.iteration,
                   is_axiom ? 0 : one.parent + 1});
  }
  return all;
}

Json StepsJson(const Derivation& derivation) {
  Json steps = Json::array();
  for (const std::vector<InsertionId>& step : derivation.steps) {
    Json ids = Json::array();
    for (const InsertionId id : step) ids.push_back(id + 1);
    steps.push_back(std::move(ids));
  }
  return steps;
}

Json EventsJson(const HistoryView& view) {
  Json events = Json::array();
  for (std::size_t i = 0; i < view.history.trace->events.size(); ++i) {
    const Event& event = view.history.trace->events[i];
    const auto index = static_cast<StringIndex>(i);
    const Json told = EventJson(view, index);
    events.push_back(
        {{"expressed", told["expressed"]},
         {"text", told["text"]},
         {"partner", event.partner == kNoIndex ? Json(nullptr)
                                               : Json(event.partner + 1)}});
  }
  return events;
}

// The symbols that made a part and that changed it.
void AddHistory(const Trace& trace, PartKind kind, Json& json) {
  const auto history = HistoryOf(trace, {kind, json["id"]});
  json["origin"] = history->origin + 1;
  json["changes"] = Json::array();
  for (const StringIndex index : history->changes)
    json["changes"].push_back(index + 1);
}

// Where it is drawn; a sensor has its parent's cell, at the side it faces.
Json PlacedJson(const Body& body, int index) {
  const Module& module = body.modules[static_cast<std::size_t>(index)];
  const bool is_sensor = module.type == ModuleType::kTouchSensor;
  const Module& cell =
      is_sensor ? body.modules[static_cast<std::size_t>(module.parent)]
                : module;
  const Facing facing =
      is_sensor ? FacingOf(cell.facing, module.slot) : module.facing;
  return {{"id", ModuleId(body, index)},
          {"type", ModuleName(module.type)},
          {"x", cell.x},
          {"y", cell.y},
          {"facing", static_cast<int>(facing)}};
}

const char* MarkName(ModuleMark mark) {
  return mark == ModuleMark::kShared ? "shared"
         : mark == ModuleMark::kNew  ? "new"
                                     : "other";
}

Json ModulesJson(const Trace& trace, const BodyDifference& difference) {
  const Body& body = trace.phenotype.body;
  const std::vector<std::string> places = PlacesOf(body);
  Json modules = Json::array();
  for (std::size_t i = 0; i < body.modules.size(); ++i) {
    Json json = PlacedJson(body, static_cast<int>(i));
    json["place"] = places[i];
    json["is_root"] = body.modules[i].parent == kNoModule;
    json["mark"] = MarkName(difference.marks[i]);
    AddHistory(trace, PartKind::kModule, json);
    modules.push_back(std::move(json));
  }
  return modules;
}

Json MissingJson(const Body& reference, const BodyDifference& difference) {
  const std::vector<std::string> places = PlacesOf(reference);
  Json missing = Json::array();
  for (const int index : difference.missing) {
    Json json = PlacedJson(reference, index);
    json["place"] = places[static_cast<std::size_t>(index)];
    missing.push_back(std::move(json));
  }
  return missing;
}

Json NodesJson(const Trace& trace) {
  const Phenotype& robot = trace.phenotype;
  Json nodes = Json::array();
  for (std::size_t i = 0; i < robot.brain.nodes.size(); ++i) {
    const Node& node = robot.brain.nodes[i];
    const bool is_input = node.type == NodeType::kInput;
    Json json{{"id", NodeName(static_cast<int>(i))},
              {"is_input", is_input},
              {"part", ModuleId(robot.body, node.module)},
              {"weight", node.weight}};
    if (!is_input) {
      json["amplitude"] = node.amplitude;
      json["period"] = node.period;
      json["phase_offset"] = node.phase_offset;
    }
    AddHistory(trace, PartKind::kNode, json);
    nodes.push_back(std::move(json));
  }
  return nodes;
}

Json EdgesJson(const Trace& trace) {
  Json edges = Json::array();
  for (const Connection& edge : trace.phenotype.brain.connections) {
    Json json{{"id", EdgeName(edge)},
              {"source", NodeName(edge.source)},
              {"destination", NodeName(edge.destination)},
              {"weight", edge.weight}};
    AddHistory(trace, PartKind::kEdge, json);
    edges.push_back(std::move(json));
  }
  return edges;
}

Json EnvironmentOf(const ExplainedRobot& robot,
                   const ExplainedEnvironment& one) {
  const HistoryView view{robot.source, robot.genotype, robot.map,
                         one.environment, one.history};
  const Trace& trace = *one.history.trace;
  const Body& reference =
      robot.environments.front().history.trace->phenotype.body;
  const BodyDifference difference =
      CompareBodies(reference, trace.phenotype.body);
  return {{"name", one.name},
          {"senses", one.senses},
          {"rules", RegulationJson(robot.genotype, one.environment)},
          {"insertions", InsertionsJson(one.history.derivation)},
          {"steps", StepsJson(one.history.derivation)},
          {"events", EventsJson(view)},
          {"modules", ModulesJson(trace, difference)},
          {"missing", MissingJson(reference, difference)},
          {"nodes", NodesJson(trace)},
          {"edges", EdgesJson(trace)}};
}

// Pages are passed on; folders are nobody else's business.
std::string_view WithoutFolders(std::string_view path) {
  return path.substr(path.rfind('/') + 1);  // npos + 1 is 0
}

Json RobotJson(const ExplainedRobot& robot) {
  Json rules = Json::array();
  for (std::size_t i = 0; i < robot.genotype.rules.size(); ++i)
    rules.push_back(GenotypeRuleJson(robot, i));
  Json environments = Json::array();
  for (const ExplainedEnvironment& one : robot.environments)
    environments.push_back(EnvironmentOf(robot, one));
  return {{"title", robot.title},
          {"file", WithoutFolders(robot.source.name())},
          {"text", robot.source.text()},
          {"axiom", robot.genotype.SymbolOf(robot.genotype.axiom).name},
          {"rules", std::move(rules)},
          {"environments", std::move(environments)}};
}

Json ColoursJson() {
  Json types = Json::object();
  for (const ModuleType type :
       {ModuleType::kCore, ModuleType::kBrick, ModuleType::kVerticalJoint,
        ModuleType::kHorizontalJoint, ModuleType::kTouchSensor})
    types[std::string(ModuleName(type))] = ModuleColour(type);
  constexpr std::size_t kNumbers = 8;  // then they repeat
  Json numbers = Json::array();
  for (std::size_t i = 0; i < kNumbers; ++i)
    numbers.push_back(
        {{"fill", NumberColour(i).fill}, {"ink", NumberColour(i).ink}});
  return {{"types", std::move(types)}, {"numbers", std::move(numbers)}};
}

}  // namespace

std::string ExplainJson(const std::vector<ExplainedRobot>& robots) {
  Json json;
  json["colours"] = ColoursJson();
  json["robots"] = Json::array();
  for (const ExplainedRobot& robot : robots)
    json["robots"].push_back(RobotJson(robot));
  // The file's name may be any bytes; JSON must stay UTF-8.
  return DumpJson(json);
}

}  // namespace plsc
