#pragma once

// What changed in genotypes and their robots, for scripts: one JSON object.

#include <string>
#include <vector>

#include "compiler/changes/written_difference.h"
#include "runtime/compare/robot_difference.h"

namespace plsc {

/// The robots of a genotype in both versions. Added and removed genotypes have
/// no environments.
struct GenotypeDifference {
  std::string genotype;
  ItemChangeKind kind = ItemChangeKind::kChanged;
  std::vector<EnvironmentDifference> environments;
  std::string limitation;  ///< as in SharedEnvironments

  bool is_different() const;
};

/// {"differs": ..., "texts": [...], "robots": [...]}; docs/git.md has the keys.
/// Without the end of the line.
std::string DifferenceJson(const std::vector<SectionChange>& texts,
                           const std::vector<GenotypeDifference>& robots);

}  // namespace plsc
