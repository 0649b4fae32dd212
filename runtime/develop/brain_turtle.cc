// Late development of the network (paper, "Mapping stage 2", VI and VII;
// authors' program, plasticoding.py: nodes 582-661, commands that change edges
// 349-410, commands that move 412-446). The authors keep two stacks, of inputs
// and of neurons, and act upon their tops; here two indices are enough (see the
// header): until both kinds exist, the nodes of the one kind are nodes 0 to
// reference, in order of creation, and from then on a stack holds its top
// alone.
//
// A new node is connected to all that the other stack holds, oldest first. The
// edge to the newest takes the weight of the new node and the others their own
// end's. The order in which edges are made is part of the robot: move_ref_*
// count edges by it, descriptors and the coupled controller add weights in it.
//
// Loops are edges but no neighbours: they do not stand in `ends_`, so nobody
// moves along one. A node that both references can reach has an edge by
// construction, which Neighbour relies on. To move a reference takes constant
// time; a new edge shifts the array behind its two ends, and to look for one
// scans them all. A brain has tens.

#include "runtime/develop/brain_turtle.h"

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
  ends_.reserve(2 * kUsualEdges);
  end_begins_.reserve(kUsualNodes + 1);
  end_begins_.push_back(0);
}

int BrainTurtle::Add(const Node& new_node) {
  brain_.nodes.push_back(new_node);
  end_begins_.push_back(end_begins_.back());
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

Effect BrainTurtle::Missing() const {
  if (input_reference_ != kNoNode) return Effect::kNoNeuron;
  return neuron_reference_ == kNoNode ? Effect::kNoNodes : Effect::kNoInput;
}

void BrainTurtle::AddEnd(int of, int other) {
  // Behind its older edges, as edges are counted by age; what belongs to later
  // nodes moves on.
  const auto next = static_cast<std::size_t>(of) + 1;
  ends_.insert(ends_.begin() + end_begins_[next], other);
  for (std::size_t i = next; i < end_begins_.size(); ++i) ++end_begins_[i];
}

void BrainTurtle::Connect(int input, int neuron, double weight) {
  AddEnd(input, neuron);
  AddEnd(neuron, input);
  brain_.connections.push_back({input, neuron, weight});
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
      Connect(index, i, node(i).weight);
    Connect(index, neuron_reference_, weight);
  }
  input_reference_ = index;
}

void BrainTurtle::AddOscillator(Node oscillator) {
  assert(oscillator.type == NodeType::kOscillator);
  const int index = Add(oscillator);
  if (input_reference_ != kNoNode) {
    const bool is_first = neuron_reference_ == kNoNode;
    for (int i = is_first ? 0 : input_reference_; i < input_reference_; ++i)
      Connect(i, index, node(i).weight);
    Connect(input_reference_, index, oscillator.weight);
  }
  neuron_reference_ = index;
}

Effect BrainTurtle::AddEdge(double weight) {
  if (!has_both()) return Missing();
  if (EdgeBetween(input_reference_, neuron_reference_) != kNoEdge)
    return Effect::kEdgeExists;
  Connect(input_reference_, neuron_reference_, weight);
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

}  // namespace plsc
