// Which items of three versions are the same one: those with names by name, the
// rules of a head by likeness (merge_rules). Keys are gone through in sorted
// order and the result is put into the versions' order afterwards
// (merge_order), so that nothing depends on which version was looked at first.
// Only rules are then set into their own order at the places where rules of
// their head stand: it is the order in which they are joined, which merge_order
// does not know.

#include "compiler/changes/merge_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "compiler/changes/merge_order.h"
#include "compiler/changes/merge_rules.h"

namespace plsc {

namespace {

using Items = std::vector<const WrittenItem*>;

bool IsRule(const WrittenItem* item) {
  return item->kind == ast::ItemKind::kRule;
}

// "rule C" to its rules, in order; "sense hot" to the one.
std::map<std::string, Items> ByKey(const Items& items) {
  std::map<std::string, Items> by_key;
  for (const WrittenItem* item : items) by_key[item->key].push_back(item);
  return by_key;
}

const Items& At(const std::map<std::string, Items>& by_key,
                const std::string& key) {
  static const Items none;
  const auto found = by_key.find(key);
  return found == by_key.end() ? none : found->second;
}

class SectionMatcher {
 public:
  explicit SectionMatcher(const SectionVersions& versions)
      : versions_(versions),
        base_(ByKey(versions.base.items)),
        ours_(ByKey(versions.ours.items)),
        theirs_(ByKey(versions.theirs.items)) {}

  std::vector<MatchedItem> Run() {
    std::set<std::string> keys;
    for (const auto* side : {&base_, &ours_, &theirs_})
      for (const auto& [key, items] : *side) keys.insert(key);
    for (const std::string& key : keys) Match(key);
    return Ordered();
  }

 private:
  void Match(const std::string& key) {
    const Items& base = At(base_, key);
    const Items& ours = At(ours_, key);
    const Items& theirs = At(theirs_, key);
    const Items& any = !ours.empty() ? ours : !theirs.empty() ? theirs : base;
    if (IsRule(any.front())) {
      std::vector<std::size_t> numbers;
      for (const MatchedRule& rule : MatchRules(base, ours, theirs)) {
        numbers.push_back(items_.size());
        Add({rule.versions, rule.clash,
             fmt::format("rule {} of {}", numbers.size(), key.substr(5))});
      }
      rules_.push_back(std::move(numbers));
      return;
    }
    const auto one = [](const Items& items) {
      return items.empty() ? nullptr : items.front();
    };
    MatchOne({one(base), one(ours), one(theirs)}, key);
  }

  void MatchOne(const ItemVersions& versions, const std::string& key) {
    const WrittenItem* left =
        versions.ours != nullptr ? versions.ours : versions.theirs;
    if (left == nullptr) return;  // deleted by both
    const bool is_deleted =
        versions.base != nullptr &&
        (versions.ours == nullptr || versions.theirs == nullptr);
    std::optional<ClashKind> clash;
    if (is_deleted) {
      if (SameContent(*left, *versions.base)) return;
      clash = ClashKind::kDeletedAndChanged;
    }
    Add({versions, clash, key});
  }

  void Add(MatchedItem item) {
    for (const WrittenItem* version :
         {item.versions.base, item.versions.ours, item.versions.theirs})
      if (version != nullptr) numbers_[version] = items_.size();
    items_.push_back(std::move(item));
  }

  std::vector<std::size_t> NumbersOf(const WrittenSection& section) const {
    std::vector<std::size_t> numbers;
    for (const WrittenItem* item : section.items)
      if (const auto found = numbers_.find(item); found != numbers_.end())
        numbers.push_back(found->second);
    return numbers;
  }

  std::vector<MatchedItem> Ordered() {
    std::vector<std::string> names;
    names.reserve(items_.size());
    for (const MatchedItem& item : items_) names.push_back(item.name);
    std::vector<std::size_t> order =
        MergeOrder({NumbersOf(versions_.base), NumbersOf(versions_.ours),
                    NumbersOf(versions_.theirs)},
                   names);
    // Wherever rules stand in the file, those of one symbol have an order.
    for (const std::vector<std::size_t>& rules : rules_) {
      const std::set<std::size_t> members(rules.begin(), rules.end());
      auto next = rules.begin();
      for (std::size_t& number : order)
        if (members.contains(number)) number = *next++;
    }
    std::vector<MatchedItem> ordered;
    ordered.reserve(order.size());
    for (const std::size_t number : order) ordered.push_back(items_[number]);
    return ordered;
  }

  const SectionVersions& versions_;
  std::map<std::string, Items> base_;
  std::map<std::string, Items> ours_;
  std::map<std::string, Items> theirs_;
  std::vector<MatchedItem> items_;
  std::vector<std::vector<std::size_t>> rules_;  // by symbol, of items_
  std::map<const WrittenItem*, std::size_t> numbers_;
};

}  // namespace

std::vector<WrittenSection> SectionsOf(const WrittenFile& file, bool is_split) {
  std::vector<WrittenSection> sections(1);
  for (const WrittenItem& item : file.items) {
    if (is_split && item.kind == ast::ItemKind::kGenotype)
      sections.push_back({item.content, {}});
    sections.back().items.push_back(&item);
  }
  return sections;
}

std::vector<MatchedItem> MatchItems(const SectionVersions& versions) {
  return SectionMatcher(versions).Run();
}

}  // namespace plsc
