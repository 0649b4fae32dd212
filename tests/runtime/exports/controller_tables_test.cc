#include "runtime/exports/controller_tables.h"

#include <catch2/catch.hpp>

#include "runtime/exports/robot_model.h"
#include "tests/sim/bodies.h"

namespace plsc {
namespace {

Node Oscillator(int module, double amplitude) {
  return {NodeType::kOscillator, module, 0.5, amplitude, 2, 0.25};
}

Node Input(int module) {
  return {NodeType::kInput, module, 0.5};
}

TEST_CASE("Nodes and edges become rows that name each other",
          "[controller_tables]") {
  Body body = LoneCore();
  const int first = Mount(body, 0, Slot::kFront, ModuleType::kVerticalJoint);
  const int touch = Mount(body, 0, Slot::kLeft, ModuleType::kTouchSensor);
  const int second = Mount(body, 0, Slot::kRight, ModuleType::kHorizontalJoint);
  const int other = Mount(body, 0, Slot::kBack, ModuleType::kTouchSensor);
  // Out of the joints' order, as crossings and commands may leave them.
  const Brain brain{
      {Input(other), Oscillator(second, 3), Input(touch), Oscillator(first, 4)},
      {{2, 1, 0.1}, {3, 3, -0.2}, {0, 3, 0.3}}};
  const ControllerTables tables =
      TablesOf(ModelOf({"a", "b"}, {body, brain}, ExportedOptions()));
  CHECK(tables.inputs == std::vector<std::string>{"touch_1s0", "touch_1s3"});
  REQUIRE(tables.oscillators.size() == 2);
  CHECK(tables.oscillators[0].joint == 1);
  CHECK(tables.oscillators[0].amplitude == 3);
  CHECK(tables.oscillators[0].period == 2);
  CHECK(tables.oscillators[0].phase_offset == 0.25);
  CHECK(tables.oscillators[1].joint == 0);
  CHECK(tables.oscillators[1].amplitude == 4);
  REQUIRE(tables.edges.size() == 3);
  CHECK_FALSE(tables.edges[0].is_loop);
  CHECK(tables.edges[0].input == 1);
  CHECK(tables.edges[0].oscillator == 0);
  CHECK(tables.edges[0].weight == 0.1);
  CHECK(tables.edges[1].is_loop);
  CHECK(tables.edges[1].oscillator == 1);
  CHECK(tables.edges[2].input == 0);
  CHECK(tables.edges[2].oscillator == 1);
}

}  // namespace
}  // namespace plsc
