#pragma once

// The turtle that grows the network: the paper's input-reference and
// neuron-reference, each the newest entry of a stack (late development, VI and
// VII). Knows nothing of the body but the module that a node belongs to.

#include <vector>

#include "sim/brain.h"

namespace plsc {

class BrainTurtle {
 public:
  /// A sensor was mounted: a new input, connected to every stacked neuron.
  void AddInput(int module, double weight);
  /// A joint was mounted: a new neuron, connected to every stacked input.
  void AddOscillator(Node node);

  // Controller-changing commands. Each does nothing while a node that it
  // needs does not exist.
  void AddEdge(double weight);
  void AddLoop(double weight);
  void MutateEdge(double amount);
  void MutateAmplitude(double amount);
  void MutatePeriod(double amount);
  void MutatePhaseOffset(double amount);

  // Controller-moving commands: edges t and d are counted from 1; numbers
  // beyond a node's last edge mean its last edge.
  void MoveInputReference(int t, int d);
  void MoveNeuronReference(int t, int d);

  Brain TakeBrain() && { return std::move(brain_); }

 private:
  bool has_both() const { return !inputs_.empty() && !neurons_.empty(); }
  Node& node(int index) {
    return brain_.nodes[static_cast<std::size_t>(index)];
  }
  int Add(const Node& new_node);
  Connection* Find(int source, int destination);
  void Connect(int input, int neuron, double weight);
  int Neighbour(int of, int edge) const;
  void MutateParameter(double Node::*parameter, double amount);

  Brain brain_;
  std::vector<int> inputs_;   ///< stack; back() is the input-reference
  std::vector<int> neurons_;  ///< stack; back() is the neuron-reference
  /// By node: the nodes at the other end of its edges, in order of creation
  /// (the paper's serial IDs). Loops are not listed.
  std::vector<std::vector<int>> neighbours_;
};

}  // namespace plsc
