#include "runtime/compare/version_difference.h"

#include <algorithm>
#include <utility>

#include "runtime/compare/robot_difference.h"

namespace plsc {

namespace {

GenotypeDifference CompareOne(const Program& before, const Program& after,
                              const SharedEnvironments& shared) {
  GenotypeDifference difference;
  difference.genotype = after.genotype.name;
  difference.environments =
      CompareRobots(shared.environments, before.genotype, after.genotype);
  difference.limitation = shared.limitation;
  return difference;
}

}  // namespace

bool VersionDifference::is_different() const {
  return std::any_of(
      robots.begin(), robots.end(),
      [](const GenotypeDifference& one) { return one.is_different(); });
}

std::optional<VersionDifference> CompareVersions(const FileVersion& before,
                                                 const FileVersion& after,
                                                 const ChooseShared& choose) {
  VersionDifference difference;
  const bool is_pair =
      before.programs.size() == 1 && after.programs.size() == 1;
  difference.texts = before.chosen.empty() && after.chosen.empty()
                         ? CompareTexts(before.source, after.source)
                         : CompareGenotypes({before.source, before.chosen},
                                            {after.source, after.chosen});
  const auto partner = [&](const Program& program,
                           const FileVersion& version) -> const Program* {
    for (const Program& other : version.programs)
      if (is_pair || other.genotype.name == program.genotype.name)
        return &other;
    return nullptr;
  };
  for (const Program& now : after.programs) {
    const Program* then = partner(now, before);
    if (then == nullptr) {
      difference.robots.push_back(
          {now.genotype.name, ItemChangeKind::kAdded, {}, ""});
      continue;
    }
    const auto shared = choose(*then, now);
    if (!shared) return std::nullopt;
    difference.robots.push_back(CompareOne(*then, now, *shared));
  }
  for (const Program& then : before.programs)
    if (partner(then, after) == nullptr)
      difference.robots.push_back(
          {then.genotype.name, ItemChangeKind::kRemoved, {}, ""});
  return difference;
}

}  // namespace plsc
