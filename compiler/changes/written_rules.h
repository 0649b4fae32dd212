#pragma once

// The rules of a symbol, as written, in numbers that rules and their parts are
// compared by.

#include <map>
#include <string>
#include <vector>

#include "compiler/changes/rule_shape.h"
#include "compiler/changes/written_items.h"

namespace plsc {

/// Numbers for texts, equal ones for equal texts.
class ContentNumbers {
 public:
  int Of(const std::string& text);
  /// Of what the parts say.
  std::vector<int> Of(const std::vector<WrittenPart>& parts);

 private:
  std::map<std::string, int> numbers_;
};

/// The rules of one symbol in one version, in the order in which active ones
/// are joined.
using WrittenRules = std::vector<const WrittenItem*>;

std::vector<RuleShape> ShapesOf(const WrittenRules& rules,
                                ContentNumbers& numbers);

}  // namespace plsc
