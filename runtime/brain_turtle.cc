#include "runtime/brain_turtle.h"

#include <algorithm>
#include <cassert>

#include "compiler/alphabet.h"

namespace plsc {

namespace {

// As many nodes and edges as most robots of the paper's size have: one
// allocation instead of five. Others grow on.
constexpr std::size_t kUsualNodes = 16;
constexpr std::size_t kUsualEdges = 32;

}  // namespace

BrainTurtle::BrainTurtle() {
  brain_.nodes.reserve(kUsualNodes);
  brain_.connections.reserve(kUsualEdges);
}

int BrainTurtle::Add(const Node& new_node) {
  brain_.nodes.push_back(new_node);
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
  if (input_reference_ != kNoNode) return Effect::kNoNeuron;
  return neuron_reference_ == kNoNode ? Effect::kNoNodes : Effect::kNoInput;
}

// In both directions the edge to the newest of the stack takes the new node's
// weight and the others their own end's; then only the newest stays stacked.
void BrainTurtle::AddInput(int module, double weight) {
  Node input;
  input.type = NodeType::kInput;
  input.module = module;
  input.weight = weight;
  const int index = Add(input);
  if (neuron_reference_ != kNoNode) {
    const bool is_first = input_reference_ == kNoNode;
    for (int i = is_first ? 0 : neuron_reference_; i < neuron_reference_; ++i)
      brain_.connections.push_back({index, i, node(i).weight});
    brain_.connections.push_back({index, neuron_reference_, weight});
  }
  input_reference_ = index;
}

void BrainTurtle::AddOscillator(Node oscillator) {
  assert(oscillator.type == NodeType::kOscillator);
  const int index = Add(oscillator);
  if (input_reference_ != kNoNode) {
    const bool is_first = neuron_reference_ == kNoNode;
    for (int i = is_first ? 0 : input_reference_; i < input_reference_; ++i)
      brain_.connections.push_back({i, index, node(i).weight});
    brain_.connections.push_back({input_reference_, index, oscillator.weight});
  }
  neuron_reference_ = index;
}

Effect BrainTurtle::AddEdge(double weight) {
  if (!has_both()) return Missing();
  if (EdgeBetween(input_reference_, neuron_reference_) != kNoEdge)
    return Effect::kEdgeExists;
  brain_.connections.push_back({input_reference_, neuron_reference_, weight});
  return Effect::kEdgeAdded;
}

// A loop needs an input although it connects none: the authors' program asks
// for both references, and the paper leaves it to "the requirements of the
// command".
Effect BrainTurtle::AddLoop(double weight) {
  if (!has_both()) return Missing();
  if (EdgeBetween(neuron_reference_, neuron_reference_) != kNoEdge)
    return Effect::kLoopExists;
  brain_.connections.push_back({neuron_reference_, neuron_reference_, weight});
  return Effect::kLoopAdded;
}

Effect BrainTurtle::MutateEdge(double amount) {
  if (!has_both()) return Missing();
  const int edge = EdgeBetween(input_reference_, neuron_reference_);
  if (edge == kNoEdge) return Effect::kNoEdge;
  double& weight = brain_.connections[static_cast<std::size_t>(edge)].weight;
  weight = std::clamp(weight + amount, plasticoding::kWeightLow,
                      plasticoding::kWeightHigh);
  return Effect::kEdgeChanged;
}

Effect BrainTurtle::MutateParameter(double Node::*parameter, double amount) {
  if (neuron_reference_ == kNoNode) return Effect::kNoNeuron;
  double& value = node(neuron_reference_).*parameter;
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

// The other end of an edge of `of`, counted from 1 in order of creation (the
// paper's serial IDs); loops are not counted. Never asked of a node without
// edges: as soon as both references exist, each has one (AddInput and
// AddOscillator connect them).
int BrainTurtle::Neighbour(int of, int edge) const {
  assert(edge >= 1);
  int neighbour = kNoNode;
  for (const Connection& one : brain_.connections) {
    // Exactly one end of an edge, both of a loop.
    if ((one.source == of) == (one.destination == of)) continue;
    neighbour = one.source == of ? one.destination : one.source;
    if (--edge == 0) break;
  }
  assert(neighbour != kNoNode);
  return neighbour;
}

Effect BrainTurtle::MoveInputReference(int t, int d) {
  if (!has_both()) return Missing();
  input_reference_ = Neighbour(Neighbour(input_reference_, t), d);
  return Effect::kNodeReached;
}

Effect BrainTurtle::MoveNeuronReference(int t, int d) {
  if (!has_both()) return Missing();
  neuron_reference_ = Neighbour(Neighbour(neuron_reference_, t), d);
  return Effect::kNodeReached;
}

}  // namespace plsc
