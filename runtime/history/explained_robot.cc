#include "runtime/history/explained_robot.h"

#include <fmt/format.h>

#include <utility>

#include "compiler/named_environments.h"
#include "runtime/develop/trace.h"

namespace plsc {

Expected<ExplainedRobot, NotExplained> ExplainRobot(
    std::string title, const Source& source, const MappedProgram& mapped,
    const std::vector<NamedEnvironment>& environments) {
  const Genotype& genotype = mapped.program.genotype;
  ExplainedRobot explained{std::move(title), source, genotype, mapped.map, {}};
  std::size_t symbols = 0;
  for (const NamedEnvironment& named : environments) {
    auto history = DevelopWithHistory(genotype, named.environment);
    if (!history) return NotExplained{NotExplained::Why::kGrown, named};
    for (const auto& step : history->derivation.steps) symbols += step.size();
    if (symbols > kMostExplainedSymbols)
      return NotExplained{NotExplained::Why::kTooManyToShow, named};
    explained.environments.push_back({named.name,
                                      SensesOf(named, genotype.states),
                                      named.environment, std::move(*history)});
  }
  return explained;
}

std::string TooManyToShow(const std::string& title) {
  return fmt::format(
      "the rewritings of {} have more than {} symbols, too many for a page",
      title, kMostExplainedSymbols);
}

}  // namespace plsc
