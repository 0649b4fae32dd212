#include "sim/modules.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("Modules weigh and fasten as the table says", "[modules]") {
  struct Row {
    const char* why;
    ModuleType type;
    double mass;
    int slots;
    double back_to_front;  // m, 0 where there is no front
  };
  const Row rows[] = {
      {"core", ModuleType::kCore, 0.090, 4, 0.089},
      {"brick: its back is its attachment", ModuleType::kBrick, 0.0102, 3,
       0.038},
      {"vertical joint", ModuleType::kVerticalJoint, 0.0107, 1, 0.038775},
      {"horizontal joint", ModuleType::kHorizontalJoint, 0.0107, 1, 0.038775},
      {"nothing sits on a sensor", ModuleType::kTouchSensor, 0.003, 0, 0},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    const ModuleShape& shape = ShapeOf(row.type);
    double mass = 0;
    for (const PartShape& part : shape.parts) mass += part.mass;
    CHECK(mass == Approx(row.mass));
    int slots = 0;
    for (const auto& slot : shape.slots) slots += slot.has_value() ? 1 : 0;
    CHECK(slots == row.slots);
    const auto& front = shape.slots[static_cast<std::size_t>(Slot::kFront)];
    if (front)
      CHECK((front->point - shape.back.point).norm() ==
            Approx(row.back_to_front));
  }
}

TEST_CASE("Slot normals and tangents are perpendicular units", "[modules]") {
  for (const ModuleType type :
       {ModuleType::kCore, ModuleType::kBrick, ModuleType::kVerticalJoint,
        ModuleType::kTouchSensor}) {
    std::vector<SlotFrame> frames{ShapeOf(type).back};
    for (const auto& slot : ShapeOf(type).slots)
      if (slot) frames.push_back(*slot);
    for (const SlotFrame& frame : frames) {
      CHECK(frame.normal.norm() == 1);
      CHECK(frame.tangent.norm() == 1);
      CHECK(frame.normal.dot(frame.tangent) == 0);
    }
  }
}

}  // namespace
}  // namespace plsc
