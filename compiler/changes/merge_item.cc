// One item in three versions. Text that is equal in two of them decides at
// once; else the head and the body are merged apart, as different people edit
// the clause and the production of one rule. A clause is merged as text if one
// side only touched it, term by term otherwise; then its comments have no place
// any more, so that with comments it is a clash. A clause that comes out with
// "and" before its first term, or none before another, was edited in ways that
// do not go together.

#include "compiler/changes/merge_item.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compiler/changes/choose.h"
#include "compiler/changes/merge_text.h"

namespace plsc {

namespace {

bool SameParts(const std::vector<WrittenPart>& a,
               const std::vector<WrittenPart>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const WrittenPart& x, const WrittenPart& y) {
                      return x.content == y.content;
                    });
}

const char* NameOfParts(ast::ItemKind kind) {
  return kind == ast::ItemKind::kEnvironment ? "entry" : "symbol";
}

std::string PartTextOf(const WrittenPart* part) {
  return part == nullptr ? "" : PartText(part->content);
}

// "and hot = True".
std::string TermText(const PartContent& term) {
  const std::string& connective = term.values[0];
  return fmt::format("{}{}{} {} {}", connective, connective.empty() ? "" : " ",
                     term.name, term.values[1], term.values[2]);
}

std::string TermTextOf(const WrittenPart* term) {
  return term == nullptr ? "" : TermText(term->content);
}

// What an item without a base is compared with: one that says nothing.
const WrittenItem& Nothing() {
  static const WrittenItem nothing;
  return nothing;
}

class ItemMerger {
 public:
  explicit ItemMerger(const ItemVersions& versions)
      : base_(versions.base != nullptr ? *versions.base : Nothing()),
        ours_(*versions.ours),
        theirs_(*versions.theirs) {}

  MergedItem Run() {
    MergeAround();
    const std::string base = CoreText(base_);
    const std::string ours = CoreText(ours_);
    const std::string theirs = CoreText(theirs_);
    if (const std::string* chosen = Choose(base, ours, theirs)) {
      merged_.core = *chosen;
    } else if (HasParts()) {
      MergeOpen();
      MergeBody();
    } else {
      MergeWhole();
    }
    return std::move(merged_);
  }

 private:
  bool HasParts() const {
    return !ours_.close.empty() && !theirs_.close.empty();
  }

  void MergeAround() {
    const auto before = MergeBlanks(base_.before, ours_.before, theirs_.before);
    const auto after = MergeBlanks(base_.after, ours_.after, theirs_.after);
    if (before && after) {
      merged_.before = *before;
      merged_.after = *after;
    } else {
      Clash("the comment", "", "", "");
    }
  }

  void MergeWhole() {
    const auto text =
        MergeText({base_.content, base_.open}, {ours_.content, ours_.open},
                  {theirs_.content, theirs_.open});
    if (text)
      merged_.core = *text;
    else
      Clash("", base_.open, ours_.open, theirs_.open);
  }

  // "rule C -> if hot = True then {".
  void MergeOpen() {
    const auto text =
        MergeText({base_.content, base_.open}, {ours_.content, ours_.open},
                  {theirs_.content, theirs_.open});
    if (text) {
      merged_.core = *text;
    } else if (ours_.kind != ast::ItemKind::kRule) {
      Clash("the head", base_.open, ours_.open, theirs_.open);
    } else {
      MergeClauses();
    }
  }

  void MergeClauses() {
    const bool has_comment =
        !CommentsIn(ours_.open).empty() || !CommentsIn(theirs_.open).empty();
    MergedParts merged = MergeParts(
        {&base_.terms, &ours_.terms, &theirs_.terms}, PartIdentity::kPlace);
    for (const PartClash& clash : merged.clashes)
      merged_.clashes.push_back({clash.kind,
                                 fmt::format("term {}", clash.position),
                                 TermTextOf(clash.base), TermTextOf(clash.ours),
                                 TermTextOf(clash.theirs)});
    if (!merged.clashes.empty()) return;
    if (has_comment || !AreJoined(merged.parts))
      return Clash("the clause", ClauseOf(base_), ClauseOf(ours_),
                   ClauseOf(theirs_));
    // The head is the item's key, so it is the same in all versions.
    merged_.core = ours_.key + " -> ";
    if (!merged.parts.empty())
      merged_.core += "if " + TextOfTerms(merged.parts) + " then ";
    merged_.core += '{';
  }

  static bool AreJoined(const std::vector<WrittenPart>& terms) {
    for (std::size_t i = 0; i < terms.size(); ++i)
      if (terms[i].content.values[0].empty() != (i == 0)) return false;
    return true;
  }

  static std::string TextOfTerms(const std::vector<WrittenPart>& terms) {
    std::string text;
    for (const WrittenPart& term : terms)
      text += (text.empty() ? "" : " ") + TermText(term.content);
    return text;
  }

  static std::string ClauseOf(const WrittenItem& rule) {
    return TextOfTerms(rule.terms);
  }

  void MergeBody() {
    const PartIdentity identity = ours_.kind == ast::ItemKind::kEnvironment
                                      ? PartIdentity::kName
                                      : PartIdentity::kPlace;
    const MergedParts merged =
        MergeParts({&base_.parts, &ours_.parts, &theirs_.parts}, identity);
    for (const PartClash& clash : merged.clashes)
      merged_.clashes.push_back(
          {clash.kind,
           fmt::format("{} {}", NameOfParts(ours_.kind), clash.position),
           PartTextOf(clash.base), PartTextOf(clash.ours),
           PartTextOf(clash.theirs)});
    const auto close = MergeBlanks(base_.close, ours_.close, theirs_.close);
    if (!close) Clash("the comment before '}'", "", "", "");
    if (!merged_.clashes.empty()) return;
    TextJoiner joiner;
    joiner.Append(merged_.core);
    for (const WrittenPart& part : merged.parts) {
      joiner.Append(part.before);
      joiner.Append(part.text);
      const bool is_entry = identity == PartIdentity::kName;
      const bool is_last = &part == &merged.parts.back();
      if (is_entry && !is_last && !part.text.ends_with(',')) joiner.Append(",");
      joiner.Append(part.after);
    }
    joiner.Append(*close);
    merged_.core = std::move(joiner).Text();
  }

  void Clash(std::string what, std::string base, std::string ours,
             std::string theirs) {
    merged_.clashes.push_back({ClashKind::kBothChanged, std::move(what),
                               std::move(base), std::move(ours),
                               std::move(theirs)});
  }

  const WrittenItem& base_;
  const WrittenItem& ours_;
  const WrittenItem& theirs_;
  MergedItem merged_;
};

}  // namespace

MergedItem MergeItem(const ItemVersions& versions) {
  return ItemMerger(versions).Run();
}

bool SameContent(const WrittenItem& a, const WrittenItem& b) {
  return a.content == b.content && SameParts(a.parts, b.parts);
}

}  // namespace plsc
