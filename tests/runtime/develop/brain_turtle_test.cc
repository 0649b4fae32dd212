#include "runtime/develop/brain_turtle.h"

#include <catch2/catch.hpp>
#include <string>

namespace plsc {
namespace {

Node Oscillator(double weight) {
  Node node;
  node.type = NodeType::kOscillator;
  node.weight = weight;
  node.amplitude = 4;
  node.period = 2;
  node.phase_offset = 3;
  return node;
}

// "0>2:0.25 1>2:0.5": every connection in order of creation.
std::string Edges(const Brain& brain) {
  std::string text;
  for (const Connection& c : brain.connections) {
    if (!text.empty()) text += ' ';
    std::string weight = std::to_string(c.weight);
    weight.erase(weight.find_last_not_of('0') + 1);
    text += std::to_string(c.source) + ">" + std::to_string(c.destination) +
            ":" + weight;
  }
  return text;
}

TEST_CASE("a new input meets every stacked neuron", "[brain_turtle]") {
  BrainTurtle turtle;
  turtle.AddOscillator(Oscillator(0.5));
  turtle.AddOscillator(Oscillator(0.75));
  turtle.AddInput(3, 0.25);
  // The newest neuron's edge has the input's weight, the others their own.
  CHECK(Edges(std::move(turtle).TakeBrain()) == "2>0:0.5 2>1:0.25");
}

TEST_CASE("a new neuron meets every stacked input", "[brain_turtle]") {
  BrainTurtle turtle;
  turtle.AddInput(1, 0.125);
  turtle.AddInput(2, 0.25);
  turtle.AddOscillator(Oscillator(0.5));
  CHECK(Edges(std::move(turtle).TakeBrain()) == "0>2:0.125 1>2:0.5");
}

TEST_CASE("a meeting leaves one node in each stack", "[brain_turtle]") {
  BrainTurtle turtle;
  turtle.AddOscillator(Oscillator(0.5));
  turtle.AddOscillator(Oscillator(0.5));
  turtle.AddInput(2, 0.25);
  turtle.AddOscillator(Oscillator(0.75));  // meets the input only
  turtle.AddInput(4, 0.125);               // meets the newest neuron only
  CHECK(Edges(std::move(turtle).TakeBrain()) ==
        "2>0:0.5 2>1:0.25 2>3:0.75 4>3:0.125");
}

TEST_CASE("commands without the nodes that they need do nothing",
          "[brain_turtle]") {
  BrainTurtle turtle;
  turtle.AddEdge(1);
  turtle.AddLoop(1);
  turtle.MutateEdge(1);
  turtle.MutateParameter(&Node::amplitude, 1);
  turtle.MoveInputReference(1, 1);
  turtle.AddOscillator(Oscillator(0.5));
  turtle.AddLoop(1);  // needs an input as well
  turtle.MoveNeuronReference(1, 1);
  const Brain brain = std::move(turtle).TakeBrain();
  CHECK(brain.connections.empty());
  CHECK(brain.nodes[0].amplitude == 4);
}

TEST_CASE("an edge or loop that exists is not added again", "[brain_turtle]") {
  BrainTurtle turtle;
  turtle.AddInput(1, 0.25);
  turtle.AddOscillator(Oscillator(0.5));
  turtle.AddEdge(0.125);
  turtle.AddLoop(-0.5);
  turtle.AddLoop(0.75);
  CHECK(Edges(std::move(turtle).TakeBrain()) == "0>1:0.5 1>1:-0.5");
}

TEST_CASE("mutations are held to the ranges of the paper", "[brain_turtle]") {
  BrainTurtle turtle;
  turtle.AddInput(1, 0.25);
  turtle.AddOscillator(Oscillator(0.5));
  turtle.MutateParameter(&Node::amplitude, 100);
  turtle.MutateParameter(&Node::period, -100);
  turtle.MutateParameter(&Node::phase_offset, 0.5);
  turtle.MutateEdge(-3);
  const Brain brain = std::move(turtle).TakeBrain();
  CHECK(brain.nodes[1].amplitude == 10);
  CHECK(brain.nodes[1].period == 1);
  CHECK(brain.nodes[1].phase_offset == 3.5);
  CHECK(brain.connections[0].weight == -1);
}

TEST_CASE("references move over two edges, numbers beyond are the last",
          "[brain_turtle]") {
  struct Row {
    const char* why;
    int t;
    int d;
    const char* loop;  ///< on which neuron a loop lands afterwards
  };
  // Neurons 0 and 1, input 2 (edges to 0, 1), neuron 3 (edge from 2).
  const std::vector<Row> rows = {
      {"first input's first neuron", 1, 1, "0>0:1."},
      {"first input's second neuron", 1, 2, "1>1:1."},
      {"beyond the edges is the last edge", 9, 9, "3>3:1."},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      BrainTurtle turtle;
      turtle.AddOscillator(Oscillator(0.5));
      turtle.AddOscillator(Oscillator(0.5));
      turtle.AddInput(2, 0.25);
      turtle.AddOscillator(Oscillator(0.75));
      turtle.MoveNeuronReference(row.t, row.d);
      turtle.AddLoop(1);
      CHECK(Edges(std::move(turtle).TakeBrain()) ==
            std::string("2>0:0.5 2>1:0.25 2>3:0.75 ") + row.loop);
    }
  }
}

TEST_CASE("an input-reference moves through its neuron's list",
          "[brain_turtle]") {
  BrainTurtle turtle;
  turtle.AddInput(1, 0.125);
  turtle.AddInput(2, 0.25);
  turtle.AddOscillator(Oscillator(0.5));  // edges 0>2, 1>2; inputs = {1}
  turtle.MoveInputReference(1, 1);        // to input 0
  turtle.MutateEdge(0.5);
  CHECK(Edges(std::move(turtle).TakeBrain()) == "0>2:0.625 1>2:0.5");
}

}  // namespace
}  // namespace plsc
