#include "runtime/pictures/brain_layout.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

Node NodeOf(NodeType type, int module) {
  Node node;
  node.type = type;
  node.module = module;
  return node;
}

TEST_CASE("inputs and oscillators have columns, in the order of modules",
          "[brain_layout]") {
  Brain brain;
  brain.nodes = {NodeOf(NodeType::kOscillator, 5), NodeOf(NodeType::kInput, 4),
                 NodeOf(NodeType::kOscillator, 2),
                 NodeOf(NodeType::kOscillator, 9)};
  const BrainLayout layout = LayOutBrain(brain, 60);
  REQUIRE(layout.places.size() == 4);
  CHECK(layout.height == 180);
  CHECK(layout.places[0].x == kOscillatorColumn);
  CHECK(layout.places[0].y == 60);
  CHECK(layout.places[2].y == 0);
  CHECK(layout.places[2].share == 0);
  CHECK(layout.places[3].y == 120);
  CHECK(layout.places[3].share == 1);
  // One input, in the middle of three rows.
  CHECK(layout.places[1].x == kInputColumn);
  CHECK(layout.places[1].y == 60);
  CHECK(layout.places[1].share == 0.5);
}

TEST_CASE("no brain takes a row", "[brain_layout]") {
  CHECK(LayOutBrain(Brain{}, 60).height == 60);
  CHECK(LayOutBrain(Brain{}, 60).places.empty());
}

}  // namespace
}  // namespace plsc
