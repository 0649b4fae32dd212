#pragma once

// The turtle that grows the network: the paper's input-reference and
// neuron-reference, each the newest entry of a stack (late development, VI and
// VII). Knows nothing of the body but the module that a node belongs to.
//
// No stack is kept. Until the first input and the first neuron meet there are
// nodes of one kind only, all of them stacked in order of creation; from then
// on each stack holds its reference alone.

#include "runtime/effect.h"
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
  Effect MutateAmplitude(double amount);
  Effect MutatePeriod(double amount);
  Effect MutatePhaseOffset(double amount);

  // Controller-moving commands: edges t and d are counted from 1; numbers
  // beyond a node's last edge mean its last edge.
  Effect MoveInputReference(int t, int d);
  Effect MoveNeuronReference(int t, int d);

  const Brain& brain() const { return brain_; }
  Brain TakeBrain() && { return std::move(brain_); }

  // What an observer asks between symbols.
  int input_reference() const { return input_reference_; }    ///< or kNoNode
  int neuron_reference() const { return neuron_reference_; }  ///< or kNoNode
  /// Index of the edge, or kNoEdge.
  int EdgeBetween(int source, int destination) const;

 private:
  Effect Missing() const;
  bool has_both() const {
    return input_reference_ != kNoNode && neuron_reference_ != kNoNode;
  }
  Node& node(int index) {
    return brain_.nodes[static_cast<std::size_t>(index)];
  }
  int Add(const Node& new_node);
  int Neighbour(int of, int edge) const;
  Effect MutateParameter(double Node::*parameter, double amount);

  Brain brain_;
  int input_reference_ = kNoNode;
  int neuron_reference_ = kNoNode;
};

}  // namespace plsc
