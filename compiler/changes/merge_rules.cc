#include "compiler/changes/merge_rules.h"

#include <map>

#include "compiler/changes/rule_shape.h"

namespace plsc {

namespace {

std::vector<int> ContentsOf(const std::vector<RuleShape>& shapes,
                            std::map<std::vector<int>, int>& numbers) {
  std::vector<int> contents;
  for (const RuleShape& shape : shapes) {
    std::vector<int> key = shape.symbols;
    key.push_back(shape.clause);
    contents.push_back(
        numbers.emplace(key, static_cast<int>(numbers.size())).first->second);
  }
  return contents;
}

const WrittenItem* RuleAt(const WrittenRules& rules, int index) {
  return index == kNoElement ? nullptr : rules[static_cast<std::size_t>(index)];
}

}  // namespace

std::vector<MatchedRule> MatchRules(const WrittenRules& base,
                                    const WrittenRules& ours,
                                    const WrittenRules& theirs) {
  ContentNumbers texts;
  const auto base_shapes = ShapesOf(base, texts);
  const auto our_shapes = ShapesOf(ours, texts);
  const auto their_shapes = ShapesOf(theirs, texts);
  std::map<std::vector<int>, int> numbers;
  SequenceVersions versions;
  versions.base = ContentsOf(base_shapes, numbers);
  versions.ours = ContentsOf(our_shapes, numbers);
  versions.theirs = ContentsOf(their_shapes, numbers);
  const SequenceMerge merge =
      MergeSequences(versions, CostsOfRules(base_shapes, our_shapes),
                     CostsOfRules(base_shapes, their_shapes));
  std::vector<MatchedRule> matched;
  for (const MergedElement& element : merge)
    matched.push_back({{RuleAt(base, element.base), RuleAt(ours, element.ours),
                        RuleAt(theirs, element.theirs)},
                       element.clash});
  return matched;
}

}  // namespace plsc
