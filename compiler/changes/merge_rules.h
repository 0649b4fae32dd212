#pragma once

// Which rules of three versions are the same one
// (compiler/changes/rule_shape.h).

#include <optional>
#include <vector>

#include "compiler/changes/merge_item.h"
#include "compiler/changes/sequence_merge.h"
#include "compiler/changes/written_rules.h"

namespace plsc {

struct MatchedRule {
  ItemVersions versions;
  std::optional<ClashKind> clash{};
};

/// In the order in which the merge joins them, without those that a side
/// deleted and the other left as they were.
std::vector<MatchedRule> MatchRules(const WrittenRules& base,
                                    const WrittenRules& ours,
                                    const WrittenRules& theirs);

}  // namespace plsc
