#include "runtime/brain_turtle.h"

#include <algorithm>
#include <cassert>

#include "compiler/alphabet.h"

namespace plsc {

int BrainTurtle::Add(const Node& new_node) {
  brain_.nodes.push_back(new_node);
  neighbours_.emplace_back();
  return static_cast<int>(brain_.nodes.size()) - 1;
}

int BrainTurtle::EdgeBetween(int source, int destination) const {
  // Robots have tens of edges, so a scan beats an index.
  for (std::size_t i = 0; i < brain_.connections.size(); ++i)
    if (brain_.connections[i].source == source &&
        brain_.connections[i].destination == destination)
      return static_cast<int>(i);
  return kNoEdge;
}

// Why a command that needs both references is not expressed.
Effect BrainTurtle::Missing() const {
  if (!inputs_.empty()) return Effect::kNoNeuron;
  return neurons_.empty() ? Effect::kNoNodes : Effect::kNoInput;
}

void BrainTurtle::Connect(int input, int neuron, double weight) {
  neighbours_[static_cast<std::size_t>(input)].push_back(neuron);
  neighbours_[static_cast<std::size_t>(neuron)].push_back(input);
  brain_.connections.push_back({input, neuron, weight});
}

// In both directions the edge to the top of the stack takes the new node's
// weight and the others their own end's; then only the top stays stacked.
void BrainTurtle::AddInput(int module, double weight) {
  Node input;
  input.type = NodeType::kInput;
  input.module = module;
  input.weight = weight;
  const int index = Add(input);
  if (neurons_.empty()) {
    inputs_.push_back(index);
    return;
  }
  inputs_ = {index};
  for (const int neuron : neurons_)
    Connect(index, neuron,
            neuron == neurons_.back() ? weight : node(neuron).weight);
  neurons_ = {neurons_.back()};
}

void BrainTurtle::AddOscillator(Node oscillator) {
  assert(oscillator.type == NodeType::kOscillator);
  const int index = Add(oscillator);
  if (inputs_.empty()) {
    neurons_.push_back(index);
    return;
  }
  neurons_ = {index};
  for (const int input : inputs_)
    Connect(input, index,
            input == inputs_.back() ? oscillator.weight : node(input).weight);
  inputs_ = {inputs_.back()};
}

Effect BrainTurtle::AddEdge(double weight) {
  if (!has_both()) return Missing();
  if (EdgeBetween(inputs_.back(), neurons_.back()) != kNoEdge)
    return Effect::kEdgeExists;
  Connect(inputs_.back(), neurons_.back(), weight);
  return Effect::kEdgeAdded;
}

// A loop needs an input although it connects none: the authors' program asks
// for both references, and the paper leaves it to "the requirements of the
// command".
Effect BrainTurtle::AddLoop(double weight) {
  if (!has_both()) return Missing();
  if (EdgeBetween(neurons_.back(), neurons_.back()) != kNoEdge)
    return Effect::kLoopExists;
  brain_.connections.push_back({neurons_.back(), neurons_.back(), weight});
  return Effect::kLoopAdded;
}

Effect BrainTurtle::MutateEdge(double amount) {
  if (!has_both()) return Missing();
  const int edge = EdgeBetween(inputs_.back(), neurons_.back());
  if (edge == kNoEdge) return Effect::kNoEdge;
  double& weight = brain_.connections[static_cast<std::size_t>(edge)].weight;
  weight = std::clamp(weight + amount, plasticoding::kWeightLow,
                      plasticoding::kWeightHigh);
  return Effect::kEdgeChanged;
}

Effect BrainTurtle::MutateParameter(double Node::*parameter, double amount) {
  if (neurons_.empty()) return Effect::kNoNeuron;
  double& value = node(neurons_.back()).*parameter;
  value = std::clamp(value + amount, plasticoding::kOscillatorLow,
                     plasticoding::kOscillatorHigh);
  return Effect::kNeuronChanged;
}

Effect BrainTurtle::MutateAmplitude(double amount) {
  return MutateParameter(&Node::amplitude, amount);
}
Effect BrainTurtle::MutatePeriod(double amount) {
  return MutateParameter(&Node::period, amount);
}
Effect BrainTurtle::MutatePhaseOffset(double amount) {
  return MutateParameter(&Node::phase_offset, amount);
}

// Never asked of a node without edges: as soon as both references exist, each
// has one (AddInput and AddOscillator connect them).
int BrainTurtle::Neighbour(int of, int edge) const {
  const std::vector<int>& list = neighbours_[static_cast<std::size_t>(of)];
  assert(!list.empty() && edge >= 1);
  const auto last = static_cast<int>(list.size());
  return list[static_cast<std::size_t>(std::min(edge, last) - 1)];
}

Effect BrainTurtle::MoveInputReference(int t, int d) {
  if (!has_both()) return Missing();
  inputs_.back() = Neighbour(Neighbour(inputs_.back(), t), d);
  return Effect::kNodeReached;
}

Effect BrainTurtle::MoveNeuronReference(int t, int d) {
  if (!has_both()) return Missing();
  neurons_.back() = Neighbour(Neighbour(neurons_.back(), t), d);
  return Effect::kNodeReached;
}

}  // namespace plsc
