// Both genotypes are developed in each environment in which the two can be
// compared (environment_pairs), each set of active rules once, and compared
// part by part (robot_parts). Environments in which the same changed are told
// together: a person wants to read a change once.

#include "runtime/compare/robot_difference.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "compiler/truth.h"
#include "runtime/compare/robot_parts.h"

namespace plsc {

namespace {

// Develops one genotype, each set of active rules once.
class Developer {
 public:
  explicit Developer(const Genotype& genotype) : genotype_(genotype) {}

  const std::optional<Observation>& In(const Environment& environment) {
    std::vector<bool> active;
    for (const Rule& rule : genotype_.rules)
      active.push_back(ClauseHolds(rule.clause, environment.values));
    auto found = known_.find(active);
    if (found == known_.end())
      found =
          known_.emplace(active, Observe(genotype_, {"", environment})).first;
    return found->second;
  }

 private:
  const Genotype& genotype_;
  std::map<std::vector<bool>, std::optional<Observation>> known_;
};

std::vector<Difference> CompareStrings(const Observation& before,
                                       const Observation& after) {
  Observation old_string;
  Observation new_string;
  old_string.string = before.string;
  new_string.string = after.string;
  return Compare(old_string, new_string, 0);
}

std::vector<Difference> CompareDeveloped(
    const std::optional<Observation>& before,
    const std::optional<Observation>& after) {
  std::vector<Difference> differences;
  if (!before && !after) return differences;  // no robot either way
  if (!before || !after) {
    constexpr const char* kGrows = "a string that grows too long";
    constexpr const char* kRobot = "a robot";
    differences.push_back({DifferenceKind::kChanged, "development",
                           before ? kRobot : kGrows, after ? kRobot : kGrows});
    return differences;
  }
  if (before->robot && after->robot)
    CompareParts(*before->robot, *after->robot, differences);
  else if (before->robot || after->robot)
    differences.push_back(
        {after->robot ? DifferenceKind::kAdded : DifferenceKind::kMissing,
         "body and brain", "", ""});
  else
    differences = CompareStrings(*before, *after);
  return differences;
}

}  // namespace

std::vector<EnvironmentDifference> CompareRobots(
    const std::vector<SharedEnvironment>& environments, const Genotype& before,
    const Genotype& after) {
  Developer old_robots(before);
  Developer new_robots(after);
  std::vector<EnvironmentDifference> compared;
  compared.reserve(environments.size());
  for (const SharedEnvironment& where : environments)
    compared.push_back({where, CompareDeveloped(old_robots.In(where.before),
                                                new_robots.In(where.after))});
  return compared;
}

std::vector<DifferenceGroup> GroupAlike(
    const std::vector<EnvironmentDifference>& environments) {
  std::vector<DifferenceGroup> groups;
  std::map<std::string, std::size_t> by_text;
  for (const EnvironmentDifference& one : environments) {
    std::string text;
    for (const Difference& difference : one.differences)
      text += Describe(difference) + '\n';
    const auto [at, is_new] = by_text.emplace(std::move(text), groups.size());
    if (is_new) groups.emplace_back();
    groups[at->second].push_back(&one);
  }
  return groups;
}

}  // namespace plsc
