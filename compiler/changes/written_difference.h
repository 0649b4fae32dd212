#pragma once

// What changed from one text of genotypes to another: items by their names,
// rules by what they say, and within these symbols and arguments. Comments,
// layout and the order of items other than rules do not count. What the
// changes do to robots is in runtime/compare/robot_difference.h.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/changes/written_items.h"
#include "grammar/source.h"

namespace plsc {

enum class ItemChangeKind : std::uint8_t { kAdded, kRemoved, kMoved, kChanged };

/// A symbol or entry of either version, or of both. Equal: unchanged.
struct PartChange {
  std::optional<PartContent> before;
  std::optional<PartContent> after;
};

struct ItemChange {
  ItemChangeKind kind = ItemChangeKind::kChanged;
  std::string name;  ///< "rule 2 of C": its number in `before`, else in `after`
  int old_line = 0;  ///< from 1; 0 if it is not there
  int new_line = 0;
  /// "rule C -> if hot = True then {", "iterations 3"; empty if not there.
  std::string before;
  std::string after;
  std::vector<PartChange> parts;  ///< of items that have parts, in order
};

/// The changes of a genotype; those before the first of several have no name.
struct SectionChange {
  std::string genotype;
  std::vector<ItemChange> items;
};

/// Sections without changes are left out. Both sources compile, or are empty.
std::vector<SectionChange> CompareTexts(const Source& before,
                                        const Source& after);

/// A genotype of a file of several, with the items that belong to all; empty:
/// the only one of the file.
struct GenotypeText {
  const Source& source;
  std::string genotype;
};
/// Of two genotypes, whatever their names; one section, or none.
std::vector<SectionChange> CompareGenotypes(const GenotypeText& before,
                                            const GenotypeText& after);

}  // namespace plsc
