#include "runtime/report/report_json.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "runtime/develop/environment_json.h"
#include "runtime/evolve/trials_yaml.h"
#include "runtime/report/claims_json.h"
#include "runtime/report/comparison.h"
#include "runtime/report/experiment_difference.h"
#include "runtime/report/report_relived_json.h"
#include "runtime/report/rounded_json.h"
#include "runtime/scenario/scenario_fitness.h"
#include "runtime/scenario/scenario_terrain.h"
#include "runtime/store/schema.h"
#include "runtime/text/json_dump.h"
#include "runtime/text/quantity.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 3;
// Clauses of states with numbers are all different; what is rare tells little.
constexpr std::size_t kMostClauses = 40;

Json Number(double value) {
  return RoundedNumber(value);
}

Json Number(const std::optional<double>& value) {
  return value ? Number(*value) : Json(nullptr);
}

Json TextOrNull(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

Json MeasuresJson(const StudyReport& report) {
  Json json = Json::array();
  for (const ReportMeasure& measure : report.measures)
    json.push_back({{"id", measure.id},
                    {"title", measure.title},
                    {"unit", TextOrNull(measure.unit)}});
  return json;
}

Json ExperimentJson(const StudyReport& report, const ReportExperiment& one) {
  Json json;
  json["name"] = one.name;
  json["encoding"] = one.experiment.genotype.encoding == Encoding::kPlasticoding
                         ? "plasticoding"
                         : "baseline";
  json["static"] = one.is_static;
  json["population"] = one.experiment.population;
  json["offspring"] = one.experiment.offspring;
  json["generations"] = one.experiment.generations;
  json["lives"] = TextOrNull(DescribeTrials(one.experiment.trials));
  json["fitness"] = HasOwnFitness(one.experiment.scenario)
                        ? Json(DescribeFitness(one.experiment.scenario))
                        : Json(nullptr);
  json["seasons"] = Json::array();
  for (std::size_t i = 0; i < one.seasons.size(); ++i) {
    const Season& season = one.experiment.scenario.seasons[i];
    json["seasons"].push_back({{"name", season.name},
                               {"shown_in", report.seasons[one.seasons[i]]},
                               {"terrain", PrintTerrain(season.terrain)},
                               {"duration", season.duration}});
  }
  return json;
}

Json QuartilesJson(const std::vector<Quartiles>& quartiles,
                   double Quartiles::*which) {
  Json json = Json::array();
  for (const Quartiles& one : quartiles) json.push_back(Number(one.*which));
  return json;
}

void AddQuartiles(const std::vector<Quartiles>& quartiles, Json& json) {
  json["low"] = QuartilesJson(quartiles, &Quartiles::low);
  json["median"] = QuartilesJson(quartiles, &Quartiles::median);
  json["high"] = QuartilesJson(quartiles, &Quartiles::high);
}

/// What tables are of, by name: indices mean nothing to who reads one of them.
class Names {
 public:
  explicit Names(const StudyReport& report) : report_(report) {}

  const std::string& Experiment(std::size_t index) const {
    return report_.experiments[index].name;
  }
  const std::string& Run(std::size_t index) const {
    return report_.runs[index].input.label;
  }
  /// The keys that begin an item about a measure in a season.
  template <typename T>
  Json Item(const T& one) const {
    return {{"measure", report_.measures[one.measure].id},
            {"season", report_.seasons[one.season]}};
  }

 private:
  const StudyReport& report_;
};

const char* NameOf(Counted of) {
  return of == Counted::kBest ? "best" : "mean";
}

Json CurveJson(const Curve& curve, const Names& names) {
  Json json = names.Item(curve);
  json["experiment"] = names.Experiment(curve.experiment);
  json["of"] = NameOf(curve.of);
  json["runs"] = curve.counts;
  AddQuartiles(curve.quartiles, json);
  return json;
}

Json FinalsJson(const Finals& finals, const Names& names) {
  const BoxPlot& box = finals.box;
  Json json = names.Item(finals);
  json["experiment"] = names.Experiment(finals.experiment);
  json["of"] = NameOf(finals.of);
  json["told"] = NameIn(kToldNames, finals.told);
  json["low_whisker"] = Number(box.low_whisker);
  json["low"] = Number(box.quartiles.low);
  json["median"] = Number(box.quartiles.median);
  json["high"] = Number(box.quartiles.high);
  json["high_whisker"] = Number(box.high_whisker);
  json["mean"] = Number(box.mean);
  json["outliers"] = Json::array();
  for (const double outlier : box.outliers)
    json["outliers"].push_back(Number(outlier));
  json["values"] = Json::array();
  for (const RunValue& value : finals.values)
    json["values"].push_back(
        {{"run", names.Run(value.run)}, {"value", Number(value.value)}});
  return json;
}

Json TestJson(const Test& test, const Names& names) {
  Json json = names.Item(test);
  json["told"] = NameIn(kToldNames, test.told);
  json["first"] = names.Experiment(test.first);
  json["second"] = names.Experiment(test.second);
  json["first_runs"] = test.first_runs;
  json["second_runs"] = test.second_runs;
  json["w"] = test.result ? Json(test.result->w) : Json(nullptr);
  json["p"] = test.result ? Number(test.result->p) : Json(nullptr);
  json["exact"] = test.result ? Json(test.result->is_exact) : Json(nullptr);
  json["stars"] = test.result ? Stars(test.result->p) : "";
  return json;
}

Json CensusCurvesJson(const CensusCurves& curves,
                      const std::vector<CensusPart>& parts,
                      const Names& names) {
  Json json{{"experiment", names.Experiment(curves.experiment)},
            {"runs", curves.counts}};
  for (std::size_t i = 0; i < parts.size(); ++i)
    AddQuartiles(curves.parts[i], json[parts[i].id]);
  return json;
}

Json ObedienceJson(const ServoObedience& one, const StudyReport& report) {
  const ReportExperiment& experiment = report.experiments[one.experiment];
  const Season& season = experiment.experiment.scenario.seasons[one.season];
  const bool is_ode = season.physics.engine == EngineKind::kOde;
  const bool is_iterative =
      is_ode && season.physics.solver == Solver::kIterative;
  return {{"experiment", experiment.name},
          {"season", season.name},
          {"engine", is_ode ? "ode" : "articulated"},
          {"solver", is_iterative ? "iterative" : "direct"},
          {"iterations", is_iterative ? Json(season.physics.solver_iterations)
                                      : Json(nullptr)},
          {"runs", one.runs},
          {"median", Number(one.errors.median)},
          {"worst", Number(one.errors.worst)}};
}

Json ValueJson(const std::optional<std::string>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json DifferencesJson(const StudyReport& report) {
  std::vector<Experiment> experiments;
  for (const ReportExperiment& one : report.experiments)
    experiments.push_back(one.experiment);
  Json json = Json::array();
  for (const KeyDifference& one : DifferencesOf(experiments)) {
    Json item{{"key", one.key},
              {"paper", ValueJson(one.paper)},
              {"between", one.is_between},
              {"values", Json::object()}};
    for (std::size_t i = 0; i < one.values.size(); ++i)
      item["values"][report.experiments[i].name] = ValueJson(one.values[i]);
    json.push_back(std::move(item));
  }
  return json;
}

/// Counts by the seasons in which rules are held, for each `name` of a rule.
Json CountsBy(const std::vector<RuleCount>& rules, std::string RuleUse::*name) {
  std::map<std::string, std::map<std::vector<bool>, int>> counts;
  std::map<std::string, int> totals;
  for (const RuleCount& one : rules) {
    counts[one.rule.*name][one.rule.is_held] += one.count;
    totals[one.rule.*name] += one.count;
  }
  std::vector<std::pair<int, std::string>> order;
  order.reserve(totals.size());
  for (const auto& [text, total] : totals) order.emplace_back(-total, text);
  std::sort(order.begin(), order.end());
  if (order.size() > kMostClauses) order.resize(kMostClauses);
  Json json = Json::array();
  for (const auto& [total, text] : order) {
    Json held = Json::array();
    for (const auto& [seasons, count] : counts[text])
      held.push_back({{"seasons", seasons}, {"rules", count}});
    json.push_back({{"name", text}, {"rules", -total}, {"held", held}});
  }
  return json;
}

Json RegulationJson(const StudyReport& report) {
  Json json = Json::array();
  for (std::size_t i = 0; i < report.experiments.size(); ++i) {
    const std::vector<RuleCount> rules = RulesOf(report, i);
    if (rules.empty()) continue;
    json.push_back({{"experiment", report.experiments[i].name},
                    {"symbols", CountsBy(rules, &RuleUse::symbol)},
                    {"clauses", CountsBy(rules, &RuleUse::clause)}});
  }
  return json;
}

/// State -> value; null where nothing is sensed.
Json SensedJson(const std::vector<SensedState>& sensed,
                const std::vector<State>& states) {
  Json json;
  for (const SensedState& state : sensed)
    json[state.name] = SensedValueJson(state.name, state.value, states);
  return json;
}

Json PortraitJson(const Portrait& portrait) {
  Json json{{"id", portrait.id},
            {"name", portrait.name},
            {"born", portrait.born},
            {"seasons", Json::array()},
            {"rules", Json::array()}};
  for (const SeasonPortrait& season : portrait.seasons)
    json["seasons"].push_back(
        {{"season", season.season},
         {"outcome", OutcomeName(season.outcome)},
         {"speed",
          season.speed ? Number(kCentimetres * *season.speed) : Json(nullptr)},
         {"balance", Number(season.balance)},
         {"size", season.size},
         {"change", NameIn(kChangeNames, season.change)},
         {"sensed", SensedJson(season.sensed, portrait.states)},
         {"svg", TextOrNull(season.svg)}});
  for (const RuleUse& rule : portrait.rules)
    json["rules"].push_back({{"symbol", rule.symbol},
                             {"clause", TextOrNull(rule.clause)},
                             {"held", rule.is_held}});
  return json;
}

Json WorkJson(const WorkDone& work) {
  return {{"sessions", work.sessions},
          {"open_sessions", work.open_sessions},
          {"first", TextOrNull(work.first)},
          {"last", TextOrNull(work.last)},
          {"hosts", work.hosts},
          {"seconds", Number(work.seconds)},
          {"cpu_seconds", Number(work.cpu_seconds)},
          {"simulated", work.simulated},
          {"looked_up", work.looked_up}};
}

Json RunJson(const ReportRun& run, const Json& experiment) {
  const RunReading& reading = run.reading;
  Json json{{"label", run.input.label},
            {"path", run.input.path},
            {"experiment", experiment},
            {"state", NameIn(kRunStateNames, reading.state)},
            {"problem", TextOrNull(reading.problem)},
            {"worker", TextOrNull(reading.worker)}};
  if (reading.state == RunState::kMissing ||
      reading.state == RunState::kDamaged)
    return json;
  const RunFacts& facts = reading.facts;
  json["name"] = facts.name;
  json["seed"] = facts.seed;
  json["generations"] = reading.population.generations;
  json["generations_planned"] = facts.planned_generations;
  json["evaluations"] = facts.evaluations;
  json["evaluations_planned"] = facts.planned_evaluations;
  json["plsc"] = facts.versions.plsc;
  json["ode"] = facts.versions.ode;
  json["compiler"] = facts.versions.compiler;
  json["machine"] = facts.versions.machine;
  json["results"] = facts.versions.results;
  json["schema"] = facts.schema;
  json["lacks"] = MissingMeasures(facts.schema);
  json["work"] = WorkJson(facts.work);
  json["best"] = reading.best ? PortraitJson(*reading.best) : Json(nullptr);
  json["relived"] = RelivedOfRunJson(run);
  if (run.check) json["engine_check"] = EngineCheckJson(*run.check);
  return json;
}

Json RunsJson(const StudyReport& report) {
  std::vector<Json> experiments(report.runs.size());
  for (std::size_t i = 0; i < report.experiments.size(); ++i)
    for (const std::size_t run : report.experiments[i].runs)
      experiments[run] = report.experiments[i].name;
  Json json = Json::array();
  for (std::size_t run = 0; run < report.runs.size(); ++run)
    json.push_back(RunJson(report.runs[run], experiments[run]));
  return json;
}

/// Of the first run that has them, and whether all others have the same.
Json ConstantsJson(const StudyReport& report) {
  Json json = Json::array();
  for (std::size_t i = 0; i < report.experiments.size(); ++i) {
    const std::vector<StoredConstant>* first = nullptr;
    bool is_same = true;
    for (const std::size_t run : report.experiments[i].runs) {
      const auto& constants = report.runs[run].reading.facts.constants;
      if (constants.empty()) continue;
      if (first == nullptr) first = &constants;
      is_same = is_same && constants == *first;
    }
    if (first == nullptr) continue;
    Json list = Json::array();
    for (const StoredConstant& constant : *first)
      list.push_back({{"season", constant.season},
                      {"name", constant.name},
                      {"value", constant.value},
                      {"unit", TextOrNull(constant.unit)}});
    json.push_back({{"experiment", report.experiments[i].name},
                    {"same", is_same},
                    {"values", list}});
  }
  return json;
}

template <typename Items, typename Write>
Json ListJson(const Items& items, const Write& write) {
  Json json = Json::array();
  for (const auto& item : items) json.push_back(write(item));
  return json;
}

}  // namespace

std::string ReportJson(const StudyReport& report,
                       const std::vector<ClaimResult>& claims,
                       const ReportMade& made) {
  const Names names(report);
  const auto named = [&](auto write) {
    return [&names, write](const auto& one) { return write(one, names); };
  };
  auto curves = CurvesOf(report);
  for (Curve& curve : CurvesOf(report, Counted::kBest))
    curves.push_back(std::move(curve));
  std::vector<Finals> boxes;
  std::vector<Test> tests;
  for (const Counted of : {Counted::kMean, Counted::kBest})
    for (const Told told : {Told::kRelived, Told::kRecorded}) {
      std::vector<Finals> finals = FinalsOf(report, of, told);
      // Tested are means alone.
      if (of == Counted::kMean)
        for (const Test& test : TestsOf(report, finals)) tests.push_back(test);
      for (Finals& one : finals) boxes.push_back(std::move(one));
    }
  Json json;
  json["plsc_report"] = kFormat;
  json["title"] = report.title;
  json["made"] = {{"by", made.by}, {"at", made.at}};
  json["single"] = report.is_single;
  json["verified"] = report.is_verified;
  json["thinned"] = report.is_thinned;
  json["generation"] =
      report.generation < 0 ? Json(nullptr) : Json(report.generation);
  json["seasons"] = report.seasons;
  json["claims"] = ClaimsJson(report, claims);
  json["claims_stated"] = ClaimsStatedJson(report);
  json["measures"] = MeasuresJson(report);
  json["experiments"] = ListJson(
      report.experiments,
      [&](const ReportExperiment& one) { return ExperimentJson(report, one); });
  json["differences"] = DifferencesJson(report);
  json["curves"] = ListJson(curves, named(CurveJson));
  json["finals"] = ListJson(boxes, named(FinalsJson));
  json["tests"] = ListJson(tests, named(TestJson));
  json["relived"] = RelivedSummaryJson(report);
  json["swaps"] = SwapsJson(report);
  json["diversity"] =
      ListJson(DiversityOf(report), [&](const CensusCurves& one) {
        return CensusCurvesJson(one, DiversityParts(), names);
      });
  json["plasticity"] =
      ListJson(PlasticityOf(report), [&](const CensusCurves& one) {
        return CensusCurvesJson(one, PlasticityParts(), names);
      });
  json["regulation"] = RegulationJson(report);
  json["runs"] = RunsJson(report);
  json["servo_errors"] = ListJson(
      ObedienceOf(report),
      [&](const ServoObedience& one) { return ObedienceJson(one, report); });
  json["constants"] = ConstantsJson(report);
  return DumpJson(json);
}

}  // namespace plsc
