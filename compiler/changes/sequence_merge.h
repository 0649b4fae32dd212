#pragma once

// Two edits of one base made into one: each element and each gap between
// elements may be touched by one side, or by both alike. Where the cheapest
// edit is not unique (an insertion beside an equal element) a merge counts only
// if every choice gives the same, because nobody knows which one was meant.

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "compiler/changes/sequence_edit.h"

namespace plsc {

enum class ClashKind : std::uint8_t {
  kBothChanged,          ///< one thing in two ways; found by who merges parts
  kBothMoved,            ///< to different places
  kBothInserted,         ///< different elements into one gap
  kDeletedAndChanged,    ///< one side deleted what the other changed
  kInsertedIntoDeleted,  ///< between elements that the other side deleted
  kAmbiguous,            ///< the cheapest edits can be merged in several ways
};

/// An element of a merge, and where it stands in each version (kNoElement:
/// not there). Both sides may have changed it. With a clash, what the sides
/// have there cannot be one.
struct MergedElement {
  int base = kNoElement;
  int ours = kNoElement;
  int theirs = kNoElement;
  std::optional<ClashKind> clash{};

  friend bool operator==(const MergedElement&, const MergedElement&) = default;
};

using SequenceMerge = std::vector<MergedElement>;

/// Three versions of a sequence. Equal numbers are equal contents.
struct SequenceVersions {
  std::vector<int> base;
  std::vector<int> ours;
  std::vector<int> theirs;
};

/// One choice of edits.
SequenceMerge MergeEdits(const SequenceVersions& versions,
                         const SequenceEdit& ours, const SequenceEdit& theirs);

/// All choices that FindEdit knows; `ours` and `theirs` are the costs from the
/// base to each side.
SequenceMerge MergeSequences(const SequenceVersions& versions,
                             const EditCosts& ours, const EditCosts& theirs);

}  // namespace plsc
