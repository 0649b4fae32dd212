#pragma once

// How the brain of one environment differs from that of another. Nodes are the
// same ones when their parts sit at the same place of the tree
// (runtime/compare/body_difference.h), edges when they join the same nodes.

#include <vector>

#include "runtime/compare/body_difference.h"
#include "sim/phenotype.h"

namespace plsc {

struct BrainDifference {
  /// By node and by connection: kOther has other numbers there, or drives
  /// another kind of joint.
  std::vector<ModuleMark> nodes;
  std::vector<ModuleMark> edges;
  /// Of the reference, by node and by connection: those that are not there.
  std::vector<int> missing_nodes;
  std::vector<int> missing_edges;

  bool has_missing() const {
    return !missing_nodes.empty() || !missing_edges.empty();
  }
};

BrainDifference CompareBrains(const Phenotype& reference,
                              const Phenotype& robot);

}  // namespace plsc
