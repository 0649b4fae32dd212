// A three-way merge as diff3 does it, of sequences instead of lines: both
// sides' edits are laid over the base, gap by gap and element by element. Each
// gap and each element may be touched by one side, or by both in the same way;
// anything else is a clash, kept at its place so that a person sees both
// versions there. Swaps are applied to places first, and what each place holds
// is merged then: one side may move what the other edits.
//
// Which edit a person made is not in the texts. Inserting B into "B C" gives "B
// B C" whether it went before or behind, and the two readings put the other
// side's neighbouring change at different places. So each side's edit is taken
// both as early and as late as the cheapest edits allow, all four pairs are
// merged, and if they do not come to the same content the element is a clash
// (kAmbiguous) rather than a guess: a wrong order of symbols is another robot,
// and nobody would see it.
//
// Linear for a given pair of edits (but for swaps, which are few); finding the
// edits is base times side (sequence_edit).

#include "compiler/changes/sequence_merge.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "compiler/changes/choose.h"

namespace plsc {

namespace {

int ContentAt(const std::vector<int>& contents, int index) {
  constexpr int kNothing = -1;
  if (index == kNoElement) return kNothing;
  return contents[static_cast<std::size_t>(index)];
}

class EditMerger {
 public:
  EditMerger(const SequenceVersions& versions, const SequenceEdit& ours,
             const SequenceEdit& theirs)
      : versions_(versions),
        ours_(ours),
        theirs_(theirs),
        at_place_(versions.base.size()),
        is_torn_(versions.base.size(), false) {
    std::iota(at_place_.begin(), at_place_.end(), std::size_t{0});
    MergeSwaps();
  }

  SequenceMerge Run() {
    const std::size_t size = versions_.base.size();
    for (std::size_t i = 0; i <= size; ++i) {
      MergeGap(i);
      if (i < size) MergeElement(at_place_[i]);
    }
    return std::move(merge_);
  }

 private:
  // Swaps of both sides happen unless they move the same element elsewhere.
  void MergeSwaps() {
    std::vector<bool> is_moved(at_place_.size(), false);
    const auto swap = [&](const std::pair<int, int>& pair) {
      const auto a = static_cast<std::size_t>(pair.first);
      const auto b = static_cast<std::size_t>(pair.second);
      if (is_moved[a] || is_moved[b]) {
        is_torn_[a] = is_torn_[b] = true;
        return;
      }
      is_moved[a] = is_moved[b] = true;
      std::swap(at_place_[a], at_place_[b]);
    };
    for (const auto& pair : ours_.swapped) swap(pair);
    for (const auto& pair : theirs_.swapped)
      if (std::find(ours_.swapped.begin(), ours_.swapped.end(), pair) ==
          ours_.swapped.end())
        swap(pair);
  }

  // Gap `i` is before base element i.
  void MergeGap(std::size_t i) {
    const std::vector<int>& ours = ours_.inserted[i];
    const std::vector<int>& theirs = theirs_.inserted[i];
    std::optional<ClashKind> clash;
    if (!ours.empty() && !theirs.empty()) {
      if (!IsSame(ours, theirs)) clash = ClashKind::kBothInserted;
    } else if (IsWithinDeleted(ours.empty() ? ours_ : theirs_, i)) {
      // The side that inserted nothing deleted what is around it. Beside one
      // deleted element there is a place for an insertion, between two there is
      // none.
      clash = ClashKind::kInsertedIntoDeleted;
    }
    for (std::size_t n = 0; n < std::max(ours.size(), theirs.size()); ++n)
      merge_.push_back({kNoElement, n < ours.size() ? ours[n] : kNoElement,
                        n < theirs.size() ? theirs[n] : kNoElement, clash});
  }

  bool IsSame(const std::vector<int>& ours,
              const std::vector<int>& theirs) const {
    return std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                      [&](int j, int k) {
                        return ContentAt(versions_.ours, j) ==
                               ContentAt(versions_.theirs, k);
                      });
  }

  static bool IsWithinDeleted(const SequenceEdit& edit, std::size_t gap) {
    return gap > 0 && gap < edit.becomes.size() &&
           edit.becomes[gap - 1] == kNoElement &&
           edit.becomes[gap] == kNoElement;
  }

  void MergeElement(std::size_t i) {
    MergedElement element{static_cast<int>(i), ours_.becomes[i],
                          theirs_.becomes[i]};
    const int base = versions_.base[i];
    const int ours = ContentAt(versions_.ours, element.ours);
    const int theirs = ContentAt(versions_.theirs, element.theirs);
    if (element.ours == kNoElement || element.theirs == kNoElement) {
      const bool is_kept =
          element.ours == kNoElement ? theirs == base : ours == base;
      if (is_kept || ours == theirs) return;  // deleted by one, or by both
      element.clash = ClashKind::kDeletedAndChanged;
    }
    if (is_torn_[i]) element.clash = ClashKind::kBothMoved;
    merge_.push_back(element);
  }

  const SequenceVersions& versions_;
  const SequenceEdit& ours_;
  const SequenceEdit& theirs_;
  std::vector<std::size_t> at_place_;  // which base element stands there
  std::vector<bool> is_torn_;          // by base element
  SequenceMerge merge_;
};

// What an element would come to; of one that both sides changed, all versions.
std::array<int, 3> ComesTo(const SequenceVersions& versions,
                           const MergedElement& element) {
  constexpr int kNothing = -1;
  const int base = ContentAt(versions.base, element.base);
  const int ours = ContentAt(versions.ours, element.ours);
  const int theirs = ContentAt(versions.theirs, element.theirs);
  if (const int* chosen = Choose(base, ours, theirs))
    return {*chosen, kNothing, kNothing};
  return {base, ours, theirs};
}

bool HasClash(const SequenceMerge& merge) {
  return std::any_of(merge.begin(), merge.end(),
                     [](const MergedElement& e) { return e.clash; });
}

}  // namespace

SequenceMerge MergeEdits(const SequenceVersions& versions,
                         const SequenceEdit& ours, const SequenceEdit& theirs) {
  return EditMerger(versions, ours, theirs).Run();
}

SequenceMerge MergeSequences(const SequenceVersions& versions,
                             const EditCosts& ours, const EditCosts& theirs) {
  const auto edits = [&](const std::vector<int>& other,
                         const EditCosts& costs) {
    std::vector<SequenceEdit> found;
    for (const auto preference :
         {EditPreference::kEarly, EditPreference::kLate})
      found.push_back(FindSwaps(
          FindEdit(versions.base.size(), other.size(), costs, preference),
          versions.base, other));
    if (found.front() == found.back()) found.pop_back();
    return found;
  };
  const auto our_edits = edits(versions.ours, ours);
  const auto their_edits = edits(versions.theirs, theirs);
  SequenceMerge first =
      MergeEdits(versions, our_edits.front(), their_edits.front());
  // What both sides did alike was one thing, however it may be read.
  if (versions.ours == versions.theirs) return first;
  // No other reading makes it one: a clash is shown as the first reads it.
  if (HasClash(first)) return first;
  const auto is_alike = [&](const MergedElement& a, const MergedElement& b) {
    return ComesTo(versions, a) == ComesTo(versions, b);
  };
  for (const SequenceEdit& our : our_edits) {
    for (const SequenceEdit& their : their_edits) {
      SequenceMerge other = MergeEdits(versions, our, their);
      if (HasClash(other)) return other;
      const auto [a, b] = std::mismatch(first.begin(), first.end(),
                                        other.begin(), other.end(), is_alike);
      if (a == first.end() && b == other.end()) continue;
      if (a == first.end()) first.push_back(*b);
      const auto where = a - first.begin();
      first[static_cast<std::size_t>(where)].clash = ClashKind::kAmbiguous;
      return first;
    }
  }
  return first;
}

}  // namespace plsc
