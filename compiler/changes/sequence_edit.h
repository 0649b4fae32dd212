#pragma once

// How one sequence became another: which elements of the first were kept or
// replaced, which were deleted, and what was inserted between them. The
// elements are known by numbers only, so that symbols of a production, terms of
// a clause and the rules of a symbol are all compared by this.

#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace plsc {

/// Index of an element that is not there.
inline constexpr int kNoElement = -1;

/// An edit of a base of n elements.
struct SequenceEdit {
  /// By base index: the index of what it became, or kNoElement.
  std::vector<int> becomes;
  /// By gap, the one before base element 0 first and the one behind the last
  /// at the end (n + 1): what was inserted there, in order.
  std::vector<std::vector<int>> inserted;
  /// Pairs of base elements that stand in each other's place; `becomes` says
  /// where each went. None unless FindSwaps looked for them.
  std::vector<std::pair<int, int>> swapped{};

  friend bool operator==(const SequenceEdit&, const SequenceEdit&) = default;
};

/// What changes cost. Deleting or inserting an element costs `one`.
struct EditCosts {
  int one = 12;
  /// Of base element i becoming element j of the other; 0 when they are equal.
  /// More than twice `one` never happens.
  std::function<int(std::size_t, std::size_t)> replace;
};

/// Where several edits are cheapest, as in deleting one of two equal
/// neighbours: the one that deletes and inserts as early, or as late, as
/// possible.
enum class EditPreference : unsigned char { kEarly, kLate };

/// The cheapest edit. Of sequences with more than kMaxAlignment pairs between
/// their equal beginnings and ends, elements there are paired in order.
SequenceEdit FindEdit(std::size_t base_size, std::size_t other_size,
                      const EditCosts& costs, EditPreference preference);

/// Takes two elements that were each replaced by the other for ones that moved.
/// `base` and `other` are the contents, equal numbers being equal contents.
SequenceEdit FindSwaps(SequenceEdit edit, std::span<const int> base,
                       std::span<const int> other);

/// 2,000 by 2,000 elements: 20 MB and some milliseconds. Rules of evolution
/// have tens of symbols.
inline constexpr std::size_t kMaxAlignment = 4'000'000;

}  // namespace plsc
