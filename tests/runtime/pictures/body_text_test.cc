#include "runtime/pictures/body_text.h"

#include <catch2/catch.hpp>

#include "runtime/develop/body_turtle.h"

namespace plsc {
namespace {

TEST_CASE("a body is drawn from above, its front up", "[body_text]") {
  BodyTurtle turtle(15, false);
  turtle.SetSlot(Slot::kLeft);
  REQUIRE(turtle.Mount(ModuleType::kHorizontalJoint));
  turtle.SetSlot(Slot::kFront);
  REQUIRE(turtle.Mount(ModuleType::kBrick));
  turtle.Move(Slot::kFront);
  turtle.SetSlot(Slot::kRight);
  REQUIRE(turtle.Mount(ModuleType::kTouchSensor));
  CHECK(BodyText(turtle.body()) ==
        "       ┌─────┐\n"
        "       │ B 3 T\n"
        "       └──•──┘\n"
        "┌─────┐┌─────┐\n"
        "│A2 2 •│ C 1 │\n"
        "└─────┘└─────┘\n");
}

TEST_CASE("numbers of three digits fit the box", "[body_text]") {
  Body body;
  Module core;
  core.number = 1;
  Module joint;
  joint.type = ModuleType::kVerticalJoint;
  joint.number = 123;
  joint.parent = 0;
  joint.slot = Slot::kFront;
  joint.y = 1;
  body.modules = {core, joint};
  CHECK(BodyText(body).find("│A1123│") != std::string::npos);
}

TEST_CASE("what differs from another body has other lines", "[body_text]") {
  // The reference: a brick left, a joint right, a sensor in front.
  BodyTurtle reference(15, false);
  reference.SetSlot(Slot::kLeft);
  REQUIRE(reference.Mount(ModuleType::kBrick));
  reference.SetSlot(Slot::kRight);
  REQUIRE(reference.Mount(ModuleType::kHorizontalJoint));
  reference.SetSlot(Slot::kFront);
  REQUIRE(reference.Mount(ModuleType::kTouchSensor));
  BodyTurtle turtle(15, false);
  turtle.SetSlot(Slot::kRight);
  REQUIRE(turtle.Mount(ModuleType::kBrick));
  REQUIRE(turtle.Move(Slot::kRight) == Effect::kModuleReached);
  turtle.SetSlot(Slot::kFront);
  REQUIRE(turtle.Mount(ModuleType::kBrick));
  CellExtent rows;
  rows.front = 1;
  CHECK(BodyText(turtle.body(), reference.body(), rows) ==
        "\n\n\n"
        "┌╌╌╌╌╌┐┌──t──┐╔═════╗┏━━━━━┓\n"
        "╎     ╎│ C 1 │• B 2 ║• B 3 ┃\n"
        "└╌╌╌╌╌┘└─────┘╚═════╝┗━━━━━┛\n");
}

}  // namespace
}  // namespace plsc
