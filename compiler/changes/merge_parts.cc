// The parts of an item, aligned and merged (sequence_merge), and parts that
// both sides changed merged value by value: one may change a weight and the
// other a period of the same joint. Costs are chosen so that a name that
// changed is cheaper than a deletion and an insertion (10 of 24), and a value
// cheaper than a name: a symbol that was edited is followed, where it stands.
// If layout and content of a part changed on different sides, the text of the
// side that changed the content is taken; a text made of both has no place for
// comments and is then a clash.

#include "compiler/changes/merge_parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/changes/choose.h"
#include "compiler/changes/merge_text.h"
#include "compiler/changes/written_rules.h"

namespace plsc {

namespace {

constexpr int kOne = 12;        // to delete or to insert
constexpr int kOtherName = 10;  // below that, and twice below two of them
constexpr int kSameName = 1;    // some value is another
constexpr int kNewConnective = 1;
constexpr int kOtherValue = 2;  // each; a symbol has at most four

const WrittenPart* PartAt(const std::vector<WrittenPart>& parts, int index) {
  if (index == kNoElement) return nullptr;
  return &parts[static_cast<std::size_t>(index)];
}

std::optional<PartContent> MergeContents(const PartContent& base,
                                         const PartContent& ours,
                                         const PartContent& theirs) {
  if (const PartContent* chosen = Choose(base, ours, theirs)) return *chosen;
  const std::size_t size = base.values.size();
  if (ours.name != base.name || theirs.name != base.name ||
      ours.values.size() != size || theirs.values.size() != size)
    return std::nullopt;
  PartContent merged = base;
  for (std::size_t i = 0; i < size; ++i) {
    const auto value =
        MergeValue(base.values[i], ours.values[i], theirs.values[i]);
    if (!value) return std::nullopt;
    merged.values[i] = *value;
  }
  return merged;
}

// Of a part that all versions have; nothing when it cannot be one.
std::optional<WrittenPart> MergePart(const WrittenPart& base,
                                     const WrittenPart& ours,
                                     const WrittenPart& theirs) {
  const auto content =
      MergeContents(base.content, ours.content, theirs.content);
  const auto before = MergeBlanks(base.before, ours.before, theirs.before);
  const auto after = MergeBlanks(base.after, ours.after, theirs.after);
  if (!content || !before || !after) return std::nullopt;
  WrittenPart merged{*content, *before, "", *after};
  const bool is_of_both =
      *content != ours.content && *content != theirs.content;
  if (is_of_both) {
    const bool has_comment =
        !CommentsIn(ours.text).empty() || !CommentsIn(theirs.text).empty();
    if (has_comment) return std::nullopt;
    merged.text = PartText(*content);
    return merged;
  }
  const std::string old_content = PartText(base.content);
  const std::string our_content = PartText(ours.content);
  const std::string their_content = PartText(theirs.content);
  const auto text =
      MergeText({old_content, base.text}, {our_content, ours.text},
                {their_content, theirs.text});
  if (!text) return std::nullopt;
  merged.text = *text;
  return merged;
}

}  // namespace

int ReplacementCost(const PartContent& from, const PartContent& to) {
  if (from == to) return 0;
  if (from.name != to.name || from.values.size() != to.values.size())
    return kOtherName;
  int cost = kSameName;
  for (std::size_t i = 0; i < from.values.size(); ++i) {
    const std::string& a = from.values[i];
    const std::string& b = to.values[i];
    if (a == b || b.empty()) continue;
    cost += a.empty() ? kNewConnective : kOtherValue;
  }
  // Only a connective was lost: of equal terms nobody guesses which one went.
  return cost == kSameName ? 0 : std::min(cost, kOtherName);
}

EditCosts CostsOfParts(const std::vector<WrittenPart>& from,
                       const std::vector<WrittenPart>& to,
                       PartIdentity identity) {
  const bool is_by_name = identity == PartIdentity::kName;
  return {kOne, [&from, &to, is_by_name](std::size_t i, std::size_t j) {
            const PartContent& a = from[i].content;
            const PartContent& b = to[j].content;
            if (is_by_name && a.name != b.name) return 2 * kOne + 1;
            return ReplacementCost(a, b);
          }};
}

std::optional<std::string> MergeValue(const std::string& base,
                                      const std::string& ours,
                                      const std::string& theirs) {
  const std::string* chosen = Choose(base, ours, theirs);
  return chosen != nullptr ? std::optional(*chosen) : std::nullopt;
}

MergedParts MergeParts(const PartVersions& versions, PartIdentity identity) {
  ContentNumbers numbers;
  const SequenceVersions contents{numbers.Of(*versions.base),
                                  numbers.Of(*versions.ours),
                                  numbers.Of(*versions.theirs)};
  const SequenceMerge merge = MergeSequences(
      contents, CostsOfParts(*versions.base, *versions.ours, identity),
      CostsOfParts(*versions.base, *versions.theirs, identity));
  MergedParts merged;
  for (const MergedElement& element : merge) {
    const WrittenPart* base = PartAt(*versions.base, element.base);
    const WrittenPart* ours = PartAt(*versions.ours, element.ours);
    const WrittenPart* theirs = PartAt(*versions.theirs, element.theirs);
    const std::size_t position = merged.parts.size() + 1;
    if (element.clash) {
      merged.clashes.push_back({*element.clash, base, ours, theirs, position});
      continue;
    }
    if (ours == nullptr || theirs == nullptr) {  // inserted
      merged.parts.push_back(ours != nullptr ? *ours : *theirs);
      continue;
    }
    const WrittenPart nothing{ours->content, "", "", ""};
    const auto part =
        MergePart(base != nullptr ? *base : nothing, *ours, *theirs);
    if (part)
      merged.parts.push_back(*part);
    else
      merged.clashes.push_back(
          {ClashKind::kBothChanged, base, ours, theirs, position});
  }
  return merged;
}

}  // namespace plsc
