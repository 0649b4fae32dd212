// What is remembered is what a person would write down, by names and places and
// not by indices, so that a golden file can be read, reviewed and merged. Long
// strings are remembered by their beginning and a hash: a file stays small, and
// any change shows. Environments are those that the file names; without any,
// all combinations of finite states, if they are few.

#include "runtime/compare/golden.h"

#include <fmt/format.h>

#include <string_view>

#include "compiler/print.h"
#include "runtime/develop/derive.h"
#include "runtime/develop/descriptors.h"
#include "runtime/develop/develop.h"
#include "runtime/develop/part_names.h"
#include "sim/fnv.h"

namespace plsc {

namespace {

GoldenString ObserveString(const Genotype& genotype,
                           const SymbolString& string) {
  GoldenString golden;
  golden.length = string.size();
  Fnv hash;  // short, the same everywhere; nobody attacks a golden file
  for (const Occurrence& occurrence : string) {
    std::string text = SymbolText(genotype, occurrence);
    hash.Add(text);
    hash.Add("\n");
    if (golden.symbols.size() < kGoldenSymbols)
      golden.symbols.push_back(std::move(text));
  }
  if (golden.length > kGoldenSymbols)
    golden.hash = fmt::format("{:016x}", hash.value());
  return golden;
}

GoldenModule ObserveModule(const Body& body, int index) {
  const Module& module = body.modules[static_cast<std::size_t>(index)];
  GoldenModule golden;
  golden.id = ModuleId(body, index);
  golden.type = ModuleName(module.type);
  golden.angle_deg = module.angle_deg;
  if (module.parent != kNoModule) {
    golden.parent = ModuleId(body, module.parent);
    golden.slot = SlotName(module.slot);
  }
  if (module.type != ModuleType::kTouchSensor) {
    golden.cell = GoldenCell{module.x, module.y};
    golden.facing = FacingName(module.facing);
  }
  return golden;
}

GoldenValues Values(const std::vector<NamedValue>& values) {
  GoldenValues golden;
  for (const NamedValue& value : values)
    golden.emplace_back(value.name, value.value);
  return golden;
}

GoldenRobot ObserveRobot(const Phenotype& phenotype) {
  GoldenRobot robot;
  const auto modules = static_cast<int>(phenotype.body.modules.size());
  for (int i = 0; i < modules; ++i)
    robot.modules.push_back(ObserveModule(phenotype.body, i));
  const auto nodes = static_cast<int>(phenotype.brain.nodes.size());
  for (int i = 0; i < nodes; ++i) {
    const Node& node = phenotype.brain.nodes[static_cast<std::size_t>(i)];
    const bool is_oscillator = node.type == NodeType::kOscillator;
    robot.nodes.push_back({NodeName(i), ModuleId(phenotype.body, node.module),
                           is_oscillator, node.weight, node.amplitude,
                           node.period, node.phase_offset});
  }
  for (const Connection& connection : phenotype.brain.connections)
    robot.edges.push_back({NodeName(connection.source),
                           NodeName(connection.destination),
                           connection.weight});
  robot.body_descriptors = Values(List(DescribeBody(phenotype.body)));
  robot.brain_descriptors = Values(List(DescribeBrain(phenotype)));
  return robot;
}

std::size_t ValueCount(const State& state) {
  return state.type == StateType::kBool ? 2 : state.values.size();
}

// The combinations of all values, the last state changing fastest.
std::vector<std::string> Combinations(const std::vector<State>& states) {
  std::size_t count = 1;
  for (const State& state : states) {
    if (state.type == StateType::kReal) return {};
    count *= ValueCount(state);
    if (count > kMaxGoldenCombinations) return {};
  }
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < count; ++i) {
    Environment environment;
    environment.values.resize(states.size());
    std::size_t rest = i;
    for (std::size_t s = states.size(); s-- > 0;) {
      environment.values[s] = static_cast<double>(rest % ValueCount(states[s]));
      rest /= ValueCount(states[s]);
    }
    texts.push_back(PrintEnvironment(environment, states));
  }
  return texts;
}

}  // namespace

std::optional<Observation> Observe(const Genotype& genotype,
                                   const NamedEnvironment& environment) {
  const ActiveRules active = Regulate(genotype, environment.environment);
  const std::optional<SymbolString> string = Derive(genotype, active);
  if (!string) return std::nullopt;
  Observation observation;
  observation.senses =
      PrintEnvironment(environment.environment, genotype.states);
  // Said already where the environment is written as an assignment.
  if (environment.name.find('=') != std::string::npos)
    observation.senses.clear();
  for (const RuleIndex rule : active.rules)
    observation.active_rules.push_back(rule + 1);
  observation.string = ObserveString(genotype, *string);
  if (genotype.alphabet->is_built_in())
    observation.robot = ObserveRobot(Develop(genotype, *string));
  return observation;
}

std::vector<std::string> DefaultEnvironments(const Program& program) {
  std::vector<std::string> names;
  for (const NamedEnvironment& named : program.environments)
    names.push_back(named.name);
  if (!names.empty()) return names;
  if (program.genotype.states.empty()) return {"any"};
  return Combinations(program.genotype.states);
}

}  // namespace plsc
