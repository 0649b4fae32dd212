#pragma once

// Questions to a history: which symbol made a part of the robot and which
// changed it (back), and what became of a symbol of the genotype (forward).

#include <optional>
#include <string>
#include <vector>

#include "runtime/develop/trace.h"

namespace plsc {

enum class PartKind : std::uint8_t { kModule, kNode, kEdge };

/// A part of a phenotype by its id: module "7", sensor "7s1", node "node3",
/// edge "node1-node3" (source, destination). "3" and "1-3" will do for nodes
/// and edges.
struct PhenotypePart {
  PartKind kind = PartKind::kModule;
  std::string id;
};

struct PartHistory {
  std::string id;                    ///< in full
  StringIndex origin = kNoIndex;     ///< the symbol that made it
  std::vector<StringIndex> changes;  ///< mutate_*, in order
};

/// Nothing when the robot has no such part.
std::optional<PartHistory> HistoryOf(const Trace& trace,
                                     const PhenotypePart& part);

/// The ids of all parts of that kind, in order of creation.
std::vector<std::string> IdsOf(const Phenotype& phenotype, PartKind kind);

/// What became of one inserted symbol.
struct Fate {
  InsertionId insertion = kNoInsertion;
  /// In the final string, or kNoIndex when it was replaced before.
  StringIndex index = kNoIndex;
  int replaced_in = 0;  ///< the iteration, when it was replaced
};

/// Every insertion of that symbol of the genotype, in order of insertion.
std::vector<Fate> FatesOf(const Derivation& derivation, RuleIndex rule,
                          std::uint32_t position);

}  // namespace plsc
