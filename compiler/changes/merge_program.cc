// A merge from the top down: genotypes by name, items of a genotype by key
// (merge_section), an item's parts as sequences (merge_item, sequence_merge).
// At each level what only one side touched is taken from that side, with its
// comments and layout, and only what both touched goes one level down. So most
// of a merged file is bytes of one of the versions.
//
// What cannot be merged is written whole, item by item, between markers as git
// knows them, since a person who chooses wants to read rules and not halves of
// them. Nothing is dropped: what one side deleted and the other changed is such
// a place, too, and of comments that both changed at the end of the file both
// are kept.
//
// Whether the merged text compiles is the caller's to ask: both sides' items
// may be right and together too many.

#include "compiler/changes/merge_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "compiler/changes/merge_order.h"
#include "compiler/changes/merge_section.h"
#include "compiler/changes/merge_text.h"

namespace plsc {

namespace {

bool SaysTheSame(const WrittenSection& a, const WrittenSection& b) {
  return std::equal(a.items.begin(), a.items.end(), b.items.begin(),
                    b.items.end(),
                    [](const WrittenItem* x, const WrittenItem* y) {
                      return x->key == y->key && SameContent(*x, *y);
                    });
}

std::string WholeText(const WrittenItem* item) {
  return item == nullptr ? "" : CoreText(*item) + item->after;
}

std::string WholeText(const WrittenSection* section) {
  std::string text;
  if (section == nullptr) return text;
  for (const WrittenItem* item : section->items)
    text += (text.empty() ? "" : item->before) + WholeText(item);
  return text;
}

// A genotype of a file of several, nullptr where a version has none.
struct MatchedSection {
  const WrittenSection* base = nullptr;
  const WrittenSection* ours = nullptr;
  const WrittenSection* theirs = nullptr;
};

class FileMerger {
 public:
  FileMerger(const WrittenFile& base, const WrittenFile& ours,
             const WrittenFile& theirs, const MergeLabels& labels)
      : ends_{base.end, ours.end, theirs.end}, labels_(labels) {
    const bool is_split = std::max({CountGenotypes(base), CountGenotypes(ours),
                                    CountGenotypes(theirs)}) > 1;
    base_ = SectionsOf(base, is_split);
    ours_ = SectionsOf(ours, is_split);
    theirs_ = SectionsOf(theirs, is_split);
  }

  MergedFile Run() {
    for (const MatchedSection& section : Sections()) Write(section);
    const auto end = MergeBlanks(ends_[0], ends_[1], ends_[2]);
    // Nobody asks for a choice between comments at the end: both are kept.
    joiner_.Append(end ? *end : ends_[1] + ends_[2]);
    merged_.text = std::move(joiner_).Text();
    return std::move(merged_);
  }

 private:
  std::vector<MatchedSection> Sections() const {
    std::map<std::string, std::size_t> numbers;
    std::vector<MatchedSection> sections;
    std::vector<std::string> names;
    const auto match = [&](const std::vector<WrittenSection>& side,
                           const WrittenSection* MatchedSection::*member) {
      for (const WrittenSection& section : side) {
        const auto [at, is_new] = numbers.emplace(section.key, sections.size());
        if (is_new) {
          sections.emplace_back();
          names.push_back(section.key);
        }
        sections[at->second].*member = &section;
      }
    };
    match(base_, &MatchedSection::base);
    match(ours_, &MatchedSection::ours);
    match(theirs_, &MatchedSection::theirs);
    const auto order = [&](const std::vector<WrittenSection>& side) {
      std::vector<std::size_t> found;
      for (const WrittenSection& section : side)
        if (!IsGone(sections[numbers.at(section.key)]))
          found.push_back(numbers.at(section.key));
      return found;
    };
    std::vector<MatchedSection> ordered;
    for (const std::size_t number :
         MergeOrder({order(base_), order(ours_), order(theirs_)}, names))
      ordered.push_back(sections[number]);
    return ordered;
  }

  // Deleted by one side and left as it was by the other, or by both.
  static bool IsGone(const MatchedSection& section) {
    if (section.base == nullptr) return false;
    if (section.ours == nullptr)
      return section.theirs == nullptr ||
             SaysTheSame(*section.theirs, *section.base);
    return section.theirs == nullptr &&
           SaysTheSame(*section.ours, *section.base);
  }

  void Write(const MatchedSection& section) {
    const WrittenSection none;
    const bool is_one_sided =
        section.ours == nullptr || section.theirs == nullptr;
    if (section.base != nullptr && is_one_sided) return WriteClash(section);
    const auto version = [&](const WrittenSection* one) {
      return one != nullptr ? *one : none;
    };
    const SectionVersions versions{version(section.base), version(section.ours),
                                   version(section.theirs)};
    for (const MatchedItem& item : MatchItems(versions)) Write(item);
  }

  void WriteClash(const MatchedSection& section) {
    const WrittenSection& left =
        section.ours != nullptr ? *section.ours : *section.theirs;
    joiner_.Append(left.items.front()->before);
    ItemClash clash;
    clash.kind = ClashKind::kDeletedAndChanged;
    (section.ours != nullptr ? clash.ours : clash.theirs) = "changed";
    AddConflict(left.key, clash);
    WriteVersions({WholeText(section.base), WholeText(section.ours),
                   WholeText(section.theirs)});
  }

  void Write(const MatchedItem& item) {
    const ItemVersions& versions = item.versions;
    if (item.clash) return WriteClash(item, {OnlyClash(item)});
    if (versions.ours == nullptr || versions.theirs == nullptr) {
      const WrittenItem& one =
          versions.ours != nullptr ? *versions.ours : *versions.theirs;
      joiner_.Append(one.before);
      joiner_.Append(CoreText(one));
      joiner_.Append(one.after);
      return;
    }
    const MergedItem merged = MergeItem(versions);
    if (!merged.clashes.empty()) return WriteClash(item, merged.clashes);
    joiner_.Append(merged.before);
    joiner_.Append(merged.core);
    joiner_.Append(merged.after);
  }

  static ItemClash OnlyClash(const MatchedItem& item) {
    const auto head = [](const WrittenItem* version) {
      return version == nullptr ? "" : version->content;
    };
    return {*item.clash, "", head(item.versions.base), head(item.versions.ours),
            head(item.versions.theirs)};
  }

  void WriteClash(const MatchedItem& item,
                  const std::vector<ItemClash>& clashes) {
    const ItemVersions& versions = item.versions;
    const WrittenItem& one =
        versions.ours != nullptr ? *versions.ours : *versions.theirs;
    joiner_.Append(one.before);
    for (const ItemClash& clash : clashes) AddConflict(item.name, clash);
    WriteVersions({WholeText(versions.base), WholeText(versions.ours),
                   WholeText(versions.theirs)});
  }

  void AddConflict(const std::string& name, const ItemClash& clash) {
    merged_.conflicts.push_back(
        {joiner_.next_line(), name + ": " + DescribeClash(clash, labels_)});
  }

  struct Versions {
    std::string base;
    std::string ours;
    std::string theirs;
  };

  void WriteVersions(const Versions& versions) {
    const auto mark = [&](char c, const std::string& label) {
      const auto size = static_cast<std::size_t>(labels_.marker_size);
      joiner_.AppendLine(std::string(size, c) + (label.empty() ? "" : " ") +
                         label);
    };
    const auto write = [&](const std::string& text) {
      if (!text.empty()) joiner_.AppendLine(text);
    };
    mark('<', labels_.ours);
    write(versions.ours);
    mark('|', labels_.base);
    write(versions.base);
    mark('=', "");
    write(versions.theirs);
    mark('>', labels_.theirs);
  }

  std::vector<WrittenSection> base_;
  std::vector<WrittenSection> ours_;
  std::vector<WrittenSection> theirs_;
  std::array<std::string, 3> ends_;
  const MergeLabels& labels_;
  TextJoiner joiner_;
  MergedFile merged_;
};

}  // namespace

MergedFile MergeFiles(const Source& base, const Source& ours,
                      const Source& theirs, const MergeLabels& labels) {
  const WrittenFile old_file = ReadItems(base);
  const WrittenFile our_file = ReadItems(ours);
  const WrittenFile their_file = ReadItems(theirs);
  return FileMerger(old_file, our_file, their_file, labels).Run();
}

}  // namespace plsc
