// The cheapest edit by dynamic programming (Wagner and Fischer 1974), with a
// cost of replacing that says how unlike two elements are, so that a changed
// element is followed instead of being deleted and inserted. Costs are whole
// numbers, so that ties are exact: they are what EditPreference decides. Read
// back from the end, pairing whenever it is as cheap leaves deletions and
// insertions for the beginning (early); refusing to pair while they are as
// cheap puts them at the end (late).
//
// Time and memory are base times other. Productions have tens of elements; for
// a hostile file the equal ends are cut off first, and what is still larger
// than kMaxAlignment is paired in order: that edit is right too, only not the
// shortest.

#include "compiler/changes/sequence_edit.h"

#include <algorithm>
#include <map>

namespace plsc {

namespace {

SequenceEdit EmptyEdit(std::size_t base_size) {
  SequenceEdit edit;
  edit.becomes.assign(base_size, kNoElement);
  edit.inserted.resize(base_size + 1);
  return edit;
}

// Elements [first, last) of both, the rest being equal in pairs.
struct Middle {
  std::size_t begin = 0;
  std::size_t base_end = 0;
  std::size_t other_end = 0;
};

Middle WithoutEqualEnds(std::size_t base_size, std::size_t other_size,
                        const EditCosts& costs) {
  Middle middle{0, base_size, other_size};
  while (middle.begin < std::min(base_size, other_size) &&
         costs.replace(middle.begin, middle.begin) == 0)
    ++middle.begin;
  while (middle.base_end > middle.begin && middle.other_end > middle.begin &&
         costs.replace(middle.base_end - 1, middle.other_end - 1) == 0) {
    --middle.base_end;
    --middle.other_end;
  }
  return middle;
}

// Cost of the cheapest edit of the first i elements into the first j, for all
// i and j.
class CostTable {
 public:
  CostTable(std::size_t rows, std::size_t columns, const EditCosts& costs)
      : columns_(columns), cells_(rows * columns) {
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < columns; ++j) Fill(i, j, costs);
  }
  int At(std::size_t i, std::size_t j) const {
    return cells_[i * columns_ + j];
  }

 private:
  void Fill(std::size_t i, std::size_t j, const EditCosts& costs) {
    int& cell = cells_[i * columns_ + j];
    if (i == 0 || j == 0) {
      cell = static_cast<int>(i + j) * costs.one;
      return;
    }
    cell = std::min(At(i - 1, j), At(i, j - 1)) + costs.one;
    cell = std::min(cell, At(i - 1, j - 1) + costs.replace(i - 1, j - 1));
  }

  std::size_t columns_;
  std::vector<int> cells_;
};

SequenceEdit Cheapest(std::size_t base_size, std::size_t other_size,
                      const EditCosts& costs, EditPreference preference) {
  const CostTable table(base_size + 1, other_size + 1, costs);
  SequenceEdit edit = EmptyEdit(base_size);
  std::size_t i = base_size;
  std::size_t j = other_size;
  const auto is_pair = [&] {
    return i > 0 && j > 0 &&
           table.At(i, j) ==
               table.At(i - 1, j - 1) + costs.replace(i - 1, j - 1);
  };
  const auto is_deletion = [&] {
    return i > 0 && table.At(i, j) == table.At(i - 1, j) + costs.one;
  };
  const auto is_insertion = [&] {
    return j > 0 && table.At(i, j) == table.At(i, j - 1) + costs.one;
  };
  // From the end: to pair whenever possible leaves the rest for the beginning.
  while (i > 0 || j > 0) {
    const bool is_late = preference == EditPreference::kLate;
    if (is_pair() && !(is_late && (is_deletion() || is_insertion()))) {
      edit.becomes[--i] = static_cast<int>(--j);
    } else if (is_deletion()) {
      --i;
    } else {
      edit.inserted[i].push_back(static_cast<int>(--j));
    }
  }
  for (std::vector<int>& gap : edit.inserted)
    std::reverse(gap.begin(), gap.end());
  return edit;
}

SequenceEdit InOrder(std::size_t base_size, std::size_t other_size,
                     const Middle& middle) {
  SequenceEdit edit = EmptyEdit(base_size);
  const std::size_t paired =
      std::min(middle.base_end, middle.other_end);  // from begin on
  for (std::size_t i = 0; i < paired; ++i)
    edit.becomes[i] = static_cast<int>(i);
  for (std::size_t j = paired; j < middle.other_end; ++j)
    edit.inserted[middle.base_end].push_back(static_cast<int>(j));
  for (std::size_t i = middle.base_end; i < base_size; ++i)
    edit.becomes[i] = static_cast<int>(other_size - (base_size - i));
  return edit;
}

}  // namespace

SequenceEdit FindEdit(std::size_t base_size, std::size_t other_size,
                      const EditCosts& costs, EditPreference preference) {
  if ((base_size + 1) <= kMaxAlignment / (other_size + 1))
    return Cheapest(base_size, other_size, costs, preference);
  const Middle middle = WithoutEqualEnds(base_size, other_size, costs);
  const std::size_t base_rest = middle.base_end - middle.begin;
  const std::size_t other_rest = middle.other_end - middle.begin;
  if (base_rest + 1 > kMaxAlignment / (other_rest + 1))
    return InOrder(base_size, other_size, middle);
  EditCosts shifted = costs;
  shifted.replace = [&](std::size_t i, std::size_t j) {
    return costs.replace(i + middle.begin, j + middle.begin);
  };
  const SequenceEdit inner =
      Cheapest(base_rest, other_rest, shifted, preference);
  const int offset = static_cast<int>(middle.begin);
  SequenceEdit edit = InOrder(base_size, other_size, middle);
  for (std::size_t i = 0; i < base_rest; ++i)
    edit.becomes[middle.begin + i] =
        inner.becomes[i] == kNoElement ? kNoElement : inner.becomes[i] + offset;
  for (std::size_t gap = 0; gap <= base_rest; ++gap) {
    edit.inserted[middle.begin + gap] = inner.inserted[gap];
    for (int& j : edit.inserted[middle.begin + gap]) j += offset;
  }
  return edit;
}

SequenceEdit FindSwaps(SequenceEdit edit, std::span<const int> base,
                       std::span<const int> other) {
  // By what an element was and what it became: those not yet paired.
  std::map<std::pair<int, int>, std::vector<std::size_t>> open;
  for (std::size_t i = 0; i < base.size(); ++i) {
    if (edit.becomes[i] == kNoElement) continue;
    const int now = other[static_cast<std::size_t>(edit.becomes[i])];
    if (now == base[i]) continue;
    const auto partner = open.find({now, base[i]});
    if (partner == open.end() || partner->second.empty()) {
      open[{base[i], now}].push_back(i);
      continue;
    }
    const std::size_t first = partner->second.back();
    partner->second.pop_back();
    std::swap(edit.becomes[first], edit.becomes[i]);
    edit.swapped.emplace_back(static_cast<int>(first), static_cast<int>(i));
  }
  return edit;
}

}  // namespace plsc
