#pragma once

// How alike two rules of one symbol are. Rules have no names: an edited one is
// known again by its clause and by what it produces.

#include <vector>

#include "compiler/changes/sequence_edit.h"

namespace plsc {

/// Numbers for what a rule says; those of two versions are from one list.
struct RuleShape {
  int clause = 0;
  std::vector<int> symbols;  ///< with their arguments, as written
  std::vector<int> names;    ///< without them

  friend bool operator==(const RuleShape&, const RuleShape&) = default;
};

/// Costs of edits of a list of rules. A rule with another clause and hardly a
/// symbol in common is another rule. Both lists must outlive the costs.
EditCosts CostsOfRules(const std::vector<RuleShape>& from,
                       const std::vector<RuleShape>& to);

}  // namespace plsc
