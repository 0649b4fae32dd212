// What compiles develops, in every environment that it names and in the two
// corners of what it senses, to a robot within all limits; the history of a
// development and the forecast of its length agree with it, and inline tests
// and lint say what they say without harm.
//
// Strings of millions of symbols are allowed but take too long here: of such
// genotypes only the first rewritings are developed.

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "compiler/compile.h"
#include "compiler/state_space.h"
#include "fuzz/require.h"
#include "runtime/advice/expectations.h"
#include "runtime/advice/lint.h"
#include "runtime/develop/derivation.h"
#include "runtime/develop/derive.h"
#include "runtime/develop/develop.h"
#include "runtime/develop/growth.h"
#include "runtime/develop/regulate.h"
#include "runtime/develop/trace.h"

namespace {

using plsc::fuzz::Require;

// Most symbols over the strings of one derivation: a millisecond or two under
// the sanitizers.
constexpr std::uint64_t kMaxSymbols = 1u << 12;
// Most environments in which lint may develop.
constexpr int kMaxEnvironments = 16;

// Symbols over all strings of the derivation; those of the last alone when it
// is refused, as then it is never made.
struct Cost {
  std::uint64_t symbols = 0;
  bool is_refused = false;
};

Cost CostOf(plsc::Genotype genotype, const plsc::ActiveRules& active) {
  Cost cost;
  const int iterations = genotype.development.iterations;
  for (int i = 0; i <= iterations && cost.symbols <= kMaxSymbols; ++i) {
    genotype.development.iterations = i;
    const std::uint64_t length = plsc::DerivedLength(genotype, active);
    if (length > plsc::kMaxStringLength) return {cost.symbols, true};
    cost.symbols += length;
  }
  return cost;
}

void RequireSoundBody(const plsc::Body& body, int max_modules) {
  std::set<std::pair<int, int>> cells;
  int mounted = 0;
  Require(
      !body.modules.empty() && body.modules[0].type == plsc::ModuleType::kCore,
      "a body begins with the core");
  for (std::size_t i = 0; i < body.modules.size(); ++i) {
    const plsc::Module& module = body.modules[i];
    const bool is_core = module.type == plsc::ModuleType::kCore;
    Require(is_core == (i == 0), "there is one core");
    if (!is_core) {
      Require(module.parent >= 0 && std::cmp_less(module.parent, i),
              "parents precede children");
      const auto& parent =
          body.modules[static_cast<std::size_t>(module.parent)];
      Require(std::cmp_equal(parent.child(module.slot), i),
              "a child sits where its parent has it");
    }
    if (module.type == plsc::ModuleType::kTouchSensor) continue;
    ++mounted;
    Require(cells.emplace(module.x, module.y).second, "no cell is used twice");
  }
  Require(mounted <= max_modules, "no more than max_modules");
}

void RequireSoundBrain(const plsc::Brain& brain, std::size_t modules) {
  const auto is_weight = [](double weight) {
    return weight >= -1 && weight <= 1;
  };
  const auto is_constant = [](double value) {
    return value >= 1 && value <= 10;
  };
  for (const plsc::Node& node : brain.nodes) {
    Require(std::cmp_less(node.module, modules), "nodes belong to modules");
    Require(is_weight(node.weight), "weights of nodes are of -1 to 1");
    if (node.type == plsc::NodeType::kInput) continue;
    Require(is_constant(node.amplitude) && is_constant(node.period) &&
                is_constant(node.phase_offset),
            "constants of oscillators are of 1 to 10");
  }
  std::set<std::pair<int, int>> edges;
  const auto nodes = brain.nodes.size();
  for (const plsc::Connection& edge : brain.connections) {
    Require(std::cmp_less(edge.source, nodes) &&
                std::cmp_less(edge.destination, nodes),
            "edges are between nodes");
    Require(is_weight(edge.weight), "weights of edges are of -1 to 1");
    Require(edges.emplace(edge.source, edge.destination).second,
            "no edge is there twice");
  }
}

void RequireSoundRobot(const plsc::Genotype& genotype,
                       const plsc::SymbolString& string) {
  const plsc::Phenotype robot = plsc::Develop(genotype, string);
  RequireSoundBody(robot.body, genotype.development.max_modules);
  RequireSoundBrain(robot.brain, robot.body.modules.size());
  const plsc::Trace trace = plsc::TraceDevelopment(genotype, string);
  Require(trace.events.size() == string.size(), "every symbol has its event");
  const plsc::Phenotype& traced = trace.phenotype;
  Require(traced.body.modules.size() == robot.body.modules.size() &&
              traced.brain.nodes.size() == robot.brain.nodes.size() &&
              traced.brain.connections.size() == robot.brain.connections.size(),
          "a traced development is the development");
}

// Whether the derivation is short enough for more than this function does.
bool RequireSoundIn(plsc::Genotype genotype,
                    const plsc::Environment& environment) {
  const plsc::ActiveRules active = plsc::Regulate(genotype, environment);
  Require(active.rules.size() <= genotype.rules.size(),
          "rules are active once");
  const int iterations = genotype.development.iterations;
  Cost cost = CostOf(genotype, active);
  while (cost.symbols > kMaxSymbols) {
    genotype.development.iterations /= 2;
    cost = CostOf(genotype, active);
  }
  const auto string = plsc::Derive(genotype, active);
  const auto history = plsc::DeriveWithHistory(genotype, active);
  Require(string.has_value() != cost.is_refused &&
              string.has_value() == history.has_value(),
          "what has too many symbols, and nothing else, is refused");
  if (string) {
    Require(string->size() == plsc::DerivedLength(genotype, active),
            "strings are as long as forecast");
    Require(plsc::FinalString(*history) == *string,
            "a history ends with the string");
    if (genotype.alphabet->is_built_in()) RequireSoundRobot(genotype, *string);
  }
  return genotype.development.iterations == iterations;
}

plsc::Environment Corner(const std::vector<plsc::State>& states, bool is_high) {
  plsc::Environment corner;
  for (const plsc::State& state : states) {
    switch (state.type) {
      case plsc::StateType::kBool:
        corner.values.push_back(is_high ? 1 : 0);
        break;
      case plsc::StateType::kReal:
        corner.values.push_back(is_high ? state.high : state.low);
        break;
      case plsc::StateType::kEnum:
        corner.values.push_back(
            is_high ? static_cast<double>(state.values.size() - 1) : 0);
        break;
    }
  }
  return corner;
}

void RunTests(const plsc::MappedProgram& mapped, const plsc::Source& source) {
  const plsc::Program& program = mapped.program;
  for (std::size_t i = 0; i < program.tests.size(); ++i) {
    const plsc::InlineTest& test = program.tests[i];
    plsc::Genotype genotype = program.genotype;
    if (test.after) genotype.development.iterations = *test.after;
    if (!RequireSoundIn(genotype, test.environment)) continue;
    if (const auto failure = plsc::RunInlineTest(mapped, i))
      plsc::fuzz::RequireSound({*failure}, source);
  }
}

// In every environment that clauses tell apart; whether some environment is
// refused, or nothing where that takes too long.
std::optional<bool> IsRefusedSomewhere(const plsc::Genotype& genotype) {
  const plsc::StateSpace space(genotype);
  if (!space.size() || *space.size() > kMaxEnvironments) return std::nullopt;
  bool is_refused = false;
  for (int i = 0; i < *space.size(); ++i) {
    const Cost cost = CostOf(genotype, plsc::Regulate(genotype, {space.At(i)}));
    if (cost.symbols > kMaxSymbols) return std::nullopt;
    is_refused |= cost.is_refused;
  }
  return is_refused;
}

void LintAll(const std::vector<plsc::MappedProgram>& programs,
             const plsc::Source& source) {
  bool is_refused = false;
  for (const plsc::MappedProgram& one : programs) {
    const auto refused = IsRefusedSomewhere(one.program.genotype);
    if (!refused) return;
    is_refused |= *refused;
  }
  const auto warnings = plsc::Lint(programs, source);
  plsc::fuzz::RequireSound(warnings, source);
  const bool is_warned = std::any_of(
      warnings.begin(), warnings.end(),
      [](const auto& w) { return w.code == plsc::Code::kMayGrowTooLong; });
  const bool is_silenced =
      source.text().find("allow") != std::string_view::npos;
  Require(is_warned == is_refused || (is_silenced && !is_warned),
          "lint warns of what is refused");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const plsc::Source source = plsc::fuzz::AsSource(data, size);
  const auto programs = plsc::CompileAllWithMap(source);
  if (!programs) return 0;
  for (const plsc::MappedProgram& mapped : *programs) {
    const plsc::Genotype& genotype = mapped.program.genotype;
    for (const plsc::NamedEnvironment& named : mapped.program.environments)
      RequireSoundIn(genotype, named.environment);
    for (const bool is_high : {false, true})
      RequireSoundIn(genotype, Corner(genotype.states, is_high));
    RunTests(mapped, source);
  }
  LintAll(*programs, source);
  return 0;
}
