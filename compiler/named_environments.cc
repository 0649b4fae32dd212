#include "compiler/named_environments.h"

#include <algorithm>
#include <utility>

#include "compiler/environment_text.h"
#include "compiler/print.h"

namespace plsc {

Result<NamedEnvironment> FindEnvironment(const Program& program,
                                         const Source& text) {
  const auto found = std::find_if(
      program.environments.begin(), program.environments.end(),
      [&](const NamedEnvironment& one) { return one.name == text.text(); });
  if (found != program.environments.end()) return *found;
  Result<Environment> environment =
      ParseEnvironment(text, program.genotype.states);
  if (!environment) return environment.diagnostics();
  std::string name = PrintEnvironment(*environment, program.genotype.states);
  return {NamedEnvironment{std::move(name), std::move(*environment)},
          environment.diagnostics()};
}

std::optional<std::vector<NamedEnvironment>> UsualEnvironments(
    const Program& program) {
  if (!program.environments.empty()) return program.environments;
  if (program.genotype.states.empty())
    return std::vector<NamedEnvironment>{{"any", {}}};
  return std::nullopt;
}

std::string SensesOf(const NamedEnvironment& named,
                     const std::vector<State>& states) {
  std::string senses = PrintEnvironment(named.environment, states);
  return senses == named.name ? std::string() : senses;
}

std::string ExampleOfEnvironment(const std::vector<State>& states) {
  Environment example;
  for (const State& state : states)
    example.values.push_back(state.type == StateType::kReal ? state.low : 0);
  return PrintEnvironment(example, states);
}

}  // namespace plsc
