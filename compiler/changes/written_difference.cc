// What changed is told in the units that people think in. Items with names are
// paired by name, wherever they stand; rules have none, so the rules of one
// head are aligned as sequences with a cost of how unlike two rules are
// (rule_shape), and a pair that is too unlike is a rule less and a rule more. A
// rule that the alignment deletes here and inserts there unchanged has moved:
// order among rules of a head is the order in which they are joined, so that a
// move is a change and not nothing.
//
// Within a changed item the parts (symbols, terms, entries) are aligned in the
// same way. Numbers of symbols and entries are compared as spelled alike
// (written_items), the rest as it is written but for layout and comments; what
// robots make of a change is runtime/compare's.
//
// The rules of a head squared, at most: heads have a few rules in evolution,
// some tens by hand.

#include "compiler/changes/written_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "compiler/changes/merge_item.h"
#include "compiler/changes/merge_parts.h"
#include "compiler/changes/merge_section.h"
#include "compiler/changes/rule_shape.h"
#include "compiler/changes/written_rules.h"

namespace plsc {

namespace {

using Items = std::vector<const WrittenItem*>;

class SectionComparison {
 public:
  SectionComparison(const Source& old_source, const Source& new_source)
      : old_source_(old_source), new_source_(new_source) {}

  std::vector<ItemChange> Run(const Items& before, const Items& after) {
    // By key, those of the new text first come first.
    std::vector<std::string> keys;
    std::map<std::string, std::pair<Items, Items>> by_key;
    const auto add = [&](const WrittenItem* item, bool is_old) {
      const auto [at, is_new] =
          by_key.emplace(item->key, std::pair<Items, Items>());
      if (is_new) keys.push_back(item->key);
      (is_old ? at->second.first : at->second.second).push_back(item);
    };
    for (const WrittenItem* item : after) add(item, false);
    for (const WrittenItem* item : before) add(item, true);
    for (const std::string& key : keys) Compare(key, by_key[key]);
    return std::move(changes_);
  }

 private:
  void Compare(const std::string& key, const std::pair<Items, Items>& items) {
    const auto& [before, after] = items;
    const WrittenItem* any = after.empty() ? before.front() : after.front();
    if (any->kind == ast::ItemKind::kRule) return CompareRules(before, after);
    Add(key, before.empty() ? nullptr : before.front(),
        after.empty() ? nullptr : after.front());
  }

  void CompareRules(const Items& before, const Items& after) {
    ContentNumbers numbers;
    const auto old_shapes = ShapesOf(before, numbers);
    const auto new_shapes = ShapesOf(after, numbers);
    const SequenceEdit edit =
        FindEdit(before.size(), after.size(),
                 CostsOfRules(old_shapes, new_shapes), EditPreference::kEarly);
    // A rule that was deleted here and inserted there, as it was, moved.
    std::map<std::size_t, std::size_t> moved;  // from new to old
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (edit.becomes[i] != kNoElement) continue;
      for (const std::vector<int>& gap : edit.inserted)
        for (const int j : gap)
          if (const auto to = static_cast<std::size_t>(j);
              new_shapes[to] == old_shapes[i] && !moved.contains(to) &&
              std::none_of(moved.begin(), moved.end(),
                           [i](const auto& pair) { return pair.second == i; }))
            moved[to] = i;
    }
    const auto is_moved = [&](std::size_t i) {
      return std::any_of(moved.begin(), moved.end(),
                         [i](const auto& pair) { return pair.second == i; });
    };
    for (std::size_t i = 0; i <= before.size(); ++i) {
      for (const int j : edit.inserted[i]) {
        const auto to = static_cast<std::size_t>(j);
        const auto from = moved.find(to);
        if (from == moved.end())
          Add(RuleName(*after[to], to), nullptr, after[to]);
        else
          AddMoved(RuleName(*before[from->second], from->second),
                   *before[from->second], *after[to]);
      }
      if (i == before.size()) break;
      if (edit.becomes[i] != kNoElement)
        Add(RuleName(*before[i], i), before[i],
            after[static_cast<std::size_t>(edit.becomes[i])]);
      else if (!is_moved(i))
        Add(RuleName(*before[i], i), before[i], nullptr);
    }
  }

  static std::string RuleName(const WrittenItem& rule, std::size_t index) {
    // The key is "rule C".
    return fmt::format("rule {} of {}", index + 1, rule.key.substr(5));
  }

  int LineIn(const Source& source, const WrittenItem* item) const {
    return item == nullptr ? 0 : source.PositionOf(item->span.begin).line;
  }

  void AddMoved(std::string name, const WrittenItem& before,
                const WrittenItem& after) {
    changes_.push_back({ItemChangeKind::kMoved,
                        std::move(name),
                        LineIn(old_source_, &before),
                        LineIn(new_source_, &after),
                        before.content,
                        after.content,
                        {}});
  }

  void Add(std::string name, const WrittenItem* before,
           const WrittenItem* after) {
    if (before != nullptr && after != nullptr && SameContent(*before, *after))
      return;
    ItemChange change;
    change.kind = before == nullptr  ? ItemChangeKind::kAdded
                  : after == nullptr ? ItemChangeKind::kRemoved
                                     : ItemChangeKind::kChanged;
    change.name = std::move(name);
    change.old_line = LineIn(old_source_, before);
    change.new_line = LineIn(new_source_, after);
    if (before != nullptr) change.before = before->content;
    if (after != nullptr) change.after = after->content;
    static const std::vector<WrittenPart> none;
    change.parts = PartChanges(before != nullptr ? before->parts : none,
                               after != nullptr ? after->parts : none);
    changes_.push_back(std::move(change));
  }

  static std::vector<PartChange> PartChanges(
      const std::vector<WrittenPart>& before,
      const std::vector<WrittenPart>& after) {
    const SequenceEdit edit =
        FindEdit(before.size(), after.size(),
                 CostsOfParts(before, after, PartIdentity::kPlace),
                 EditPreference::kEarly);
    std::vector<PartChange> changes;
    for (std::size_t i = 0; i <= before.size(); ++i) {
      for (const int j : edit.inserted[i])
        changes.push_back(
            {std::nullopt, after[static_cast<std::size_t>(j)].content});
      if (i == before.size()) break;
      PartChange change;
      change.before = before[i].content;
      if (edit.becomes[i] != kNoElement)
        change.after = after[static_cast<std::size_t>(edit.becomes[i])].content;
      changes.push_back(std::move(change));
    }
    return changes;
  }

  const Source& old_source_;
  const Source& new_source_;
  std::vector<ItemChange> changes_;
};

// Of one genotype of the file, and those that belong to all.
Items ItemsOf(const WrittenFile& file, const std::string& genotype) {
  Items items;
  for (const WrittenSection& section : SectionsOf(file, !genotype.empty()))
    if (section.key.empty() || section.key == "genotype " + genotype)
      items.insert(items.end(), section.items.begin(), section.items.end());
  return items;
}

}  // namespace

std::vector<SectionChange> CompareTexts(const Source& before,
                                        const Source& after) {
  const WrittenFile old_file = ReadItems(before);
  const WrittenFile new_file = ReadItems(after);
  const bool is_split =
      std::max(CountGenotypes(old_file), CountGenotypes(new_file)) > 1;
  const auto old_sections = SectionsOf(old_file, is_split);
  const auto new_sections = SectionsOf(new_file, is_split);
  std::vector<SectionChange> changes;
  const auto with_key = [](const std::vector<WrittenSection>& sections,
                           const std::string& key) {
    return std::find_if(
        sections.begin(), sections.end(),
        [&](const WrittenSection& section) { return section.key == key; });
  };
  const auto name_of = [](const WrittenSection& section) {
    constexpr std::size_t kKeyword = 9;  // of "genotype gecko"
    return section.key.empty() ? "" : section.key.substr(kKeyword);
  };
  const auto compare = [&](const WrittenSection& section, const Items& from,
                           const Items& to) {
    auto items = SectionComparison(before, after).Run(from, to);
    if (!items.empty()) changes.push_back({name_of(section), std::move(items)});
  };
  for (const WrittenSection& section : new_sections) {
    const auto same = with_key(old_sections, section.key);
    compare(section, same == old_sections.end() ? Items() : same->items,
            section.items);
  }
  for (const WrittenSection& section : old_sections)
    if (with_key(new_sections, section.key) == new_sections.end())
      compare(section, section.items, {});
  return changes;
}

std::vector<SectionChange> CompareGenotypes(const GenotypeText& before,
                                            const GenotypeText& after) {
  const WrittenFile old_file = ReadItems(before.source);
  const WrittenFile new_file = ReadItems(after.source);
  auto items = SectionComparison(before.source, after.source)
                   .Run(ItemsOf(old_file, before.genotype),
                        ItemsOf(new_file, after.genotype));
  if (items.empty()) return {};
  return {{after.genotype, std::move(items)}};
}

}  // namespace plsc
