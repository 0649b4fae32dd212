#pragma once

// Two versions of a file: what changed in its text and in its robots, genotype
// by genotype.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compiler/changes/written_difference.h"
#include "compiler/program.h"
#include "runtime/compare/difference_json.h"
#include "runtime/compare/environment_pairs.h"

namespace plsc {

/// One of the two. Without text it has no genotypes.
struct FileVersion {
  Source source;
  std::vector<Program> programs;
  std::string chosen;  ///< a genotype's name; empty: all of the file
};

struct VersionDifference {
  std::vector<SectionChange> texts;
  std::vector<GenotypeDifference> robots;

  bool is_different() const;
};

/// Where two genotypes are to be compared; nothing ends the comparison.
using ChooseShared = std::function<std::optional<SharedEnvironments>(
    const Program& before, const Program& after)>;

/// Genotypes by their names; the only ones of both, whatever their names.
/// Nothing if `choose` says so.
std::optional<VersionDifference> CompareVersions(const FileVersion& before,
                                                 const FileVersion& after,
                                                 const ChooseShared& choose);

}  // namespace plsc
