#pragma once

// The parts of an item (symbols of a production, terms of a clause, entries of
// an environment) in three versions, made into one list. A part that both
// sides changed is merged value by value.

#include <optional>
#include <vector>

#include "compiler/changes/sequence_merge.h"
#include "compiler/changes/written_items.h"

namespace plsc {

/// What two sides made of the same part; the parts are those of the versions,
/// nullptr where they have none.
struct PartClash {
  ClashKind kind{};
  const WrittenPart* base = nullptr;
  const WrittenPart* ours = nullptr;
  const WrittenPart* theirs = nullptr;
  std::size_t position = 0;  ///< in the merge, from 1
};

/// What changes of parts cost: one value less than a name, a name less than a
/// deletion and an insertion, so that parts that changed places are found to
/// have been replaced where they stand. A term that becomes the first loses its
/// connective for nothing; to take one costs little, since terms are added
/// behind others.
int ReplacementCost(const PartContent& from, const PartContent& to);

/// Parts that are known by their names: other names never become each other.
enum class PartIdentity : unsigned char { kPlace, kName };

/// Of one list of parts becoming another; both must outlive the costs.
EditCosts CostsOfParts(const std::vector<WrittenPart>& from,
                       const std::vector<WrittenPart>& to,
                       PartIdentity identity);

struct PartVersions {
  const std::vector<WrittenPart>* base = nullptr;
  const std::vector<WrittenPart>* ours = nullptr;
  const std::vector<WrittenPart>* theirs = nullptr;
};

struct MergedParts {
  std::vector<WrittenPart> parts;
  std::vector<PartClash> clashes;  ///< then `parts` are not to be used
};

MergedParts MergeParts(const PartVersions& versions, PartIdentity identity);

/// The same three-way choice of one value; nothing when both changed it.
std::optional<std::string> MergeValue(const std::string& base,
                                      const std::string& ours,
                                      const std::string& theirs);

}  // namespace plsc
