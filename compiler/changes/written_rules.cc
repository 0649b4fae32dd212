#include "compiler/changes/written_rules.h"

#include <utility>

namespace plsc {

int ContentNumbers::Of(const std::string& text) {
  return numbers_.emplace(text, static_cast<int>(numbers_.size()))
      .first->second;
}

std::vector<int> ContentNumbers::Of(const std::vector<WrittenPart>& parts) {
  std::vector<int> numbers;
  numbers.reserve(parts.size());
  for (const WrittenPart& part : parts)
    numbers.push_back(Of(PartText(part.content)));
  return numbers;
}

std::vector<RuleShape> ShapesOf(const WrittenRules& rules,
                                ContentNumbers& numbers) {
  std::vector<RuleShape> shapes;
  shapes.reserve(rules.size());
  for (const WrittenItem* rule : rules) {
    RuleShape shape;
    shape.clause = numbers.Of(rule->content);
    shape.symbols = numbers.Of(rule->parts);
    for (const WrittenPart& part : rule->parts)
      shape.names.push_back(numbers.Of(part.content.name));
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

}  // namespace plsc
