#pragma once

// The turtle that grows the network: the paper's input-reference and
// neuron-reference, each the newest entry of a stack (late development, VI and
// VII). Knows nothing of the body but the module that a node belongs to.
//
// No stack is kept. Until the first input and the first neuron meet there are
// nodes of one kind only, all of them stacked in order of creation; from then
// on each stack holds its reference alone.

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

#include "runtime/develop/effect.h"
#include "sim/brain.h"

namespace plsc {

inline constexpr int kNoNode = -1;
inline constexpr int kNoEdge = -1;

class BrainTurtle {
 public:
  BrainTurtle();

  /// A sensor was mounted: a new input, connected to every stacked neuron.
  void AddInput(int module, double weight);
  /// A joint was mounted: a new neuron, connected to every stacked input.
  void AddOscillator(Node node);

  // Controller-changing commands. Each does nothing while a node that it
  // needs does not exist; the effect says so.
  Effect AddEdge(double weight);
  Effect AddLoop(double weight);
  Effect MutateEdge(double amount);
  /// Of the amplitude, period or phase offset.
  Effect MutateParameter(double Node::*parameter, double amount);

  // Controller-moving commands: edges t and d are counted from 1; numbers
  // beyond a node's last edge mean its last edge.
  Effect MoveInputReference(int t, int d) {
    if (!has_both()) return Missing();
    input_reference_ = Neighbour(Neighbour(input_reference_, t), d);
    return Effect::kNodeReached;
  }
  Effect MoveNeuronReference(int t, int d) {
    if (!has_both()) return Missing();
    neuron_reference_ = Neighbour(Neighbour(neuron_reference_, t), d);
    return Effect::kNodeReached;
  }

  const Brain& brain() const { return brain_; }
  Brain TakeBrain() && { return std::move(brain_); }

  // What an observer asks between symbols.
  int input_reference() const { return input_reference_; }    ///< or kNoNode
  int neuron_reference() const { return neuron_reference_; }  ///< or kNoNode
  /// Index of the edge, or kNoEdge.
  int EdgeBetween(int source, int destination) const;

 private:
  /// Why a command that needs both references is not expressed. Pure, so that
  /// a reader that ignores effects does not ask.
  [[gnu::pure]] Effect Missing() const;
  bool has_both() const {
    return input_reference_ != kNoNode && neuron_reference_ != kNoNode;
  }
  Node& node(int index) {
    return brain_.nodes[static_cast<std::size_t>(index)];
  }
  int Add(const Node& new_node);
  void Connect(int input, int neuron, double weight);
  void AddEnd(int of, int other);
  // Never asked of a node without edges: as soon as both references exist,
  // each has one (AddInput and AddOscillator connect them).
  int Neighbour(int of, int edge) const {
    const auto node = static_cast<std::size_t>(of);
    const int begin = end_begins_[node];
    const int count = end_begins_[node + 1] - begin;
    assert(count > 0 && edge >= 1);
    return ends_[static_cast<std::size_t>(begin + std::min(edge, count) - 1)];
  }

  Brain brain_;
  /// For each node the nodes at the other end of its edges, in order of
  /// creation (the paper's serial IDs), without loops: node i's begin at
  /// end_begins_[i]. One array, because commands that look at edges are many
  /// and commands that make one are few.
  std::vector<int> ends_;
  std::vector<int> end_begins_;  ///< one more for the end of the last
  int input_reference_ = kNoNode;
  int neuron_reference_ = kNoNode;
};

}  // namespace plsc
