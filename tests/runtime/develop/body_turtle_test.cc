#include "runtime/develop/body_turtle.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

constexpr int kPaperLimit = 15;

BodyTurtle PaperTurtle() {
  return BodyTurtle(kPaperLimit, false);
}

const Module& Last(const BodyTurtle& turtle) {
  return turtle.body().modules.back();
}

TEST_CASE("a turtle starts on a lone core", "[body_turtle]") {
  const BodyTurtle turtle = PaperTurtle();
  REQUIRE(turtle.body().modules.size() == 1);
  CHECK(turtle.body().modules[0].type == ModuleType::kCore);
  CHECK(turtle.body().modules[0].number == 1);
}

TEST_CASE("a module without a mounting command is not expressed",
          "[body_turtle]") {
  BodyTurtle turtle = PaperTurtle();
  CHECK_FALSE(turtle.Mount(ModuleType::kBrick));
  turtle.SetSlot(Slot::kLeft);
  CHECK(turtle.Mount(ModuleType::kBrick).module == 1);
  // The successful mounting emptied the slot-reference.
  CHECK_FALSE(turtle.Mount(ModuleType::kBrick));
}

TEST_CASE("each slot leads to its cell and facing", "[body_turtle]") {
  struct Row {
    const char* why;
    Slot slot;
    int x;
    int y;
    Facing facing;
  };
  const std::vector<Row> rows = {
      {"front is +y", Slot::kFront, 0, 1, Facing::kFront},
      {"right is +x", Slot::kRight, 1, 0, Facing::kRight},
      {"left is -x", Slot::kLeft, -1, 0, Facing::kLeft},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      BodyTurtle turtle = PaperTurtle();
      turtle.SetSlot(row.slot);
      REQUIRE(turtle.Mount(ModuleType::kBrick));
      CHECK(Last(turtle).x == row.x);
      CHECK(Last(turtle).y == row.y);
      CHECK(Last(turtle).facing == row.facing);
      CHECK(Last(turtle).number == 2);
    }
  }
}

TEST_CASE("a later mounting command overwrites an earlier one",
          "[body_turtle]") {
  BodyTurtle turtle = PaperTurtle();
  turtle.SetSlot(Slot::kLeft);
  turtle.SetSlot(Slot::kRight);
  REQUIRE(turtle.Mount(ModuleType::kBrick));
  CHECK(Last(turtle).slot == Slot::kRight);
}

TEST_CASE("a taken slot keeps the slot-reference for after a move",
          "[body_turtle]") {
  BodyTurtle turtle = PaperTurtle();
  turtle.SetSlot(Slot::kFront);
  REQUIRE(turtle.Mount(ModuleType::kBrick));
  turtle.SetSlot(Slot::kFront);
  REQUIRE_FALSE(turtle.Mount(ModuleType::kBrick));
  turtle.Move(Slot::kFront);
  REQUIRE(turtle.Mount(ModuleType::kBrick));
  CHECK(Last(turtle).y == 2);
}

TEST_CASE("a cell that is taken discards the module, not the command",
          "[body_turtle]") {
  // A square of bricks: front, its left, that one's left (back down) meets
  // the core's left neighbour.
  BodyTurtle turtle = PaperTurtle();
  turtle.SetSlot(Slot::kLeft);
  REQUIRE(turtle.Mount(ModuleType::kBrick));  // (-1, 0)
  turtle.SetSlot(Slot::kFront);
  REQUIRE(turtle.Mount(ModuleType::kBrick));  // (0, 1)
  turtle.Move(Slot::kFront);
  turtle.SetSlot(Slot::kLeft);
  REQUIRE(turtle.Mount(ModuleType::kBrick));  // (-1, 1), facing left
  turtle.Move(Slot::kLeft);
  turtle.SetSlot(Slot::kLeft);
  const std::size_t before = turtle.body().modules.size();
  CHECK_FALSE(turtle.Mount(ModuleType::kHorizontalJoint));
  CHECK(turtle.body().modules.size() == before);
  // A sensor takes no cell, so it may sit where the joint could not.
  REQUIRE(turtle.Mount(ModuleType::kTouchSensor));
  CHECK(Last(turtle).slot == Slot::kLeft);
}

TEST_CASE("the core's back opens only when its other sides are taken",
          "[body_turtle]") {
  BodyTurtle turtle = PaperTurtle();
  turtle.SetSlot(Slot::kFront);
  REQUIRE(turtle.Mount(ModuleType::kTouchSensor));  // sensors count as taking
  turtle.SetSlot(Slot::kLeft);
  REQUIRE(turtle.Mount(ModuleType::kBrick));
  turtle.SetSlot(Slot::kRight);
  REQUIRE(turtle.Mount(ModuleType::kBrick));
  turtle.SetSlot(Slot::kRight);
  REQUIRE(turtle.Mount(ModuleType::kBrick));
  CHECK(Last(turtle).slot == Slot::kBack);
  CHECK(Last(turtle).y == -1);
  CHECK(Last(turtle).facing == Facing::kBack);
}

TEST_CASE("on a joint every module goes to the front and no sensor fits",
          "[body_turtle]") {
  BodyTurtle turtle = PaperTurtle();
  turtle.SetSlot(Slot::kRight);
  REQUIRE(turtle.Mount(ModuleType::kHorizontalJoint));
  turtle.Move(Slot::kRight);
  turtle.SetSlot(Slot::kLeft);
  CHECK_FALSE(turtle.Mount(ModuleType::kTouchSensor));
  REQUIRE(turtle.Mount(ModuleType::kBrick));
  CHECK(Last(turtle).slot == Slot::kFront);
  CHECK(Last(turtle).x == 2);
}

TEST_CASE("moving enters neither an empty slot nor a sensor", "[body_turtle]") {
  BodyTurtle turtle = PaperTurtle();
  turtle.SetSlot(Slot::kFront);
  REQUIRE(turtle.Mount(ModuleType::kTouchSensor));
  turtle.Move(Slot::kFront);
  turtle.Move(Slot::kLeft);
  turtle.Move(Slot::kBack);  // at the start: nowhere to go
  turtle.SetSlot(Slot::kRight);
  REQUIRE(turtle.Mount(ModuleType::kBrick));
  CHECK(Last(turtle).parent == 0);
}

TEST_CASE("move_back leaves a joint towards its parent", "[body_turtle]") {
  // The paper's rule V reads as if it went to the joint's front.
  BodyTurtle turtle = PaperTurtle();
  turtle.SetSlot(Slot::kFront);
  REQUIRE(turtle.Mount(ModuleType::kVerticalJoint));
  turtle.Move(Slot::kLeft);  // on the core: nothing at its left
  turtle.Move(Slot::kFront);
  turtle.Move(Slot::kBack);
  turtle.SetSlot(Slot::kLeft);
  REQUIRE(turtle.Mount(ModuleType::kBrick));
  CHECK(Last(turtle).parent == 0);
}

TEST_CASE("once the limit is reached not even a sensor is mounted",
          "[body_turtle]") {
  BodyTurtle turtle(2, false);
  turtle.SetSlot(Slot::kFront);
  REQUIRE(turtle.Mount(ModuleType::kTouchSensor));  // not counted
  turtle.SetSlot(Slot::kLeft);
  REQUIRE(turtle.Mount(ModuleType::kBrick));
  turtle.SetSlot(Slot::kRight);
  CHECK_FALSE(turtle.Mount(ModuleType::kBrick));
  CHECK_FALSE(turtle.Mount(ModuleType::kTouchSensor));
}

TEST_CASE("move_to_new follows a mounted brick but no sensor",
          "[body_turtle]") {
  BodyTurtle turtle(kPaperLimit, true);
  turtle.SetSlot(Slot::kFront);
  REQUIRE(turtle.Mount(ModuleType::kBrick));
  turtle.SetSlot(Slot::kFront);
  REQUIRE(turtle.Mount(ModuleType::kTouchSensor));
  turtle.SetSlot(Slot::kLeft);
  REQUIRE(turtle.Mount(ModuleType::kBrick));
  CHECK(Last(turtle).parent == 1);
  turtle.Move(Slot::kBack);
  turtle.Move(Slot::kBack);
  turtle.SetSlot(Slot::kLeft);
  REQUIRE(turtle.Mount(ModuleType::kBrick));
  CHECK(Last(turtle).parent == 0);
}

TEST_CASE("a module is rolled relative to its parent", "[body_turtle]") {
  using enum ModuleType;
  struct Row {
    const char* why;
    ModuleType child;
    ModuleType parent;
    int angle_deg;
  };
  const std::vector<Row> rows = {
      {"a vertical joint is a rolled joint", kVerticalJoint, kCore, 90},
      {"two of them keep the roll", kVerticalJoint, kVerticalJoint, 0},
      {"a brick is rolled back upright", kBrick, kVerticalJoint, 270},
      {"so is a horizontal joint", kHorizontalJoint, kVerticalJoint, 270},
      {"a vertical joint on a horizontal one", kVerticalJoint, kHorizontalJoint,
       90},
      {"nothing to roll", kBrick, kHorizontalJoint, 0},
  };
  for (const Row& row : rows) DYNAMIC_SECTION(row.why) {
      CHECK(RollAngle(row.child, row.parent) == row.angle_deg);
    }
}

}  // namespace
}  // namespace plsc
