#pragma once

// The items of one genotype in three versions: which are the same, which stay,
// and in which order they are written.

#include <optional>
#include <string>
#include <vector>

#include "compiler/changes/merge_item.h"

namespace plsc {

/// The items of a genotype, and in a file of several also those before the
/// first. `key` is "genotype gecko", or empty.
struct WrittenSection {
  std::string key;
  std::vector<const WrittenItem*> items;
};

/// Cut at the items `genotype` if `is_split`, else one section.
std::vector<WrittenSection> SectionsOf(const WrittenFile& file, bool is_split);

/// An item of the merge. With a clash it cannot be merged, else MergeItem says.
struct MatchedItem {
  ItemVersions versions;
  std::optional<ClashKind> clash{};
  std::string name;  ///< "rule 2 of C", "environment tilted"
};

struct SectionVersions {
  WrittenSection base;
  WrittenSection ours;
  WrittenSection theirs;
};

/// In the order of the merge.
std::vector<MatchedItem> MatchItems(const SectionVersions& versions);

}  // namespace plsc
