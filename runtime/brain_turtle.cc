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

Connection* BrainTurtle::Find(int source, int destination) {
  // Robots have tens of edges, so a scan beats an index.
  for (Connection& connection : brain_.connections)
    if (connection.source == source && connection.destination == destination)
      return &connection;
  return nullptr;
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

void BrainTurtle::AddEdge(double weight) {
  if (!has_both() || Find(inputs_.back(), neurons_.back()) != nullptr) return;
  Connect(inputs_.back(), neurons_.back(), weight);
}

// A loop needs an input although it connects none: the authors' program asks
// for both references, and the paper leaves it to "the requirements of the
// command".
void BrainTurtle::AddLoop(double weight) {
  if (!has_both() || Find(neurons_.back(), neurons_.back()) != nullptr) return;
  brain_.connections.push_back({neurons_.back(), neurons_.back(), weight});
}

void BrainTurtle::MutateEdge(double amount) {
  if (!has_both()) return;
  Connection* edge = Find(inputs_.back(), neurons_.back());
  if (edge == nullptr) return;
  edge->weight = std::clamp(edge->weight + amount, plasticoding::kWeightLow,
                            plasticoding::kWeightHigh);
}

void BrainTurtle::MutateParameter(double Node::*parameter, double amount) {
  if (neurons_.empty()) return;
  double& value = node(neurons_.back()).*parameter;
  value = std::clamp(value + amount, plasticoding::kOscillatorLow,
                     plasticoding::kOscillatorHigh);
}

void BrainTurtle::MutateAmplitude(double amount) {
  MutateParameter(&Node::amplitude, amount);
}
void BrainTurtle::MutatePeriod(double amount) {
  MutateParameter(&Node::period, amount);
}
void BrainTurtle::MutatePhaseOffset(double amount) {
  MutateParameter(&Node::phase_offset, amount);
}

// Never asked of a node without edges: as soon as both references exist, each
// has one (AddInput and AddOscillator connect them).
int BrainTurtle::Neighbour(int of, int edge) const {
  const std::vector<int>& list = neighbours_[static_cast<std::size_t>(of)];
  assert(!list.empty() && edge >= 1);
  const auto last = static_cast<int>(list.size());
  return list[static_cast<std::size_t>(std::min(edge, last) - 1)];
}

void BrainTurtle::MoveInputReference(int t, int d) {
  if (!has_both()) return;
  inputs_.back() = Neighbour(Neighbour(inputs_.back(), t), d);
}

void BrainTurtle::MoveNeuronReference(int t, int d) {
  if (!has_both()) return;
  neurons_.back() = Neighbour(Neighbour(neurons_.back(), t), d);
}

}  // namespace plsc
