#include "sim/modules.h"

#include <cassert>

namespace plsc {
namespace {

using Eigen::Vector3d;

// m, from the centre. The core's half side; but a brick's slots lie 1.5 mm
// inside its faces, so that it sinks that far into its neighbours.
constexpr double kCoreSlot = 0.0445;
constexpr double kBrickSlot = 0.019;

/// The four sides of a cube-like module whose own front is +y.
std::array<std::optional<SlotFrame>, kSlots> FourSlots(double distance) {
  std::array<std::optional<SlotFrame>, kSlots> slots;
  const auto add = [&](Slot slot, const Vector3d& normal) {
    slots[static_cast<std::size_t>(slot)] =
        SlotFrame{distance * normal, normal, Vector3d::UnitZ()};
  };
  add(Slot::kBack, -Vector3d::UnitY());
  add(Slot::kFront, Vector3d::UnitY());
  add(Slot::kRight, Vector3d::UnitX());
  add(Slot::kLeft, -Vector3d::UnitX());
  return slots;
}

ModuleShape MakeCore() {
  ModuleShape shape;
  shape.parts = {{Part::kCore, {0.089, 0.089, 0.045}, Vector3d::Zero(), 0.090}};
  shape.slots = FourSlots(kCoreSlot);
  shape.back = *shape.slots[0];
  return shape;
}

ModuleShape MakeBrick() {
  ModuleShape shape;
  shape.parts = {
      {Part::kBrick, {0.041, 0.041, 0.0355}, Vector3d::Zero(), 0.0102}};
  shape.slots = FourSlots(kBrickSlot);
  shape.back = *shape.slots[0];
  shape.slots[0].reset();  // taken by the brick's own attachment
  return shape;
}

/// Origin at the back slot point, +x forward, the hinge's axis along +y.
ModuleShape MakeJoint() {
  ModuleShape shape;
  shape.parts = {
      {Part::kFrame, {0.022, 0.03575, 0.010}, {0.011, 0, 0}, 0.0017},
      {Part::kServo, {0.0245, 0.02575, 0.015}, {0.026525, 0, 0}, 0.009},
      // Weightless there too: the servo's 9 g include it.
      {Part::kPlate, {0.001, 0.034, 0.034}, {0.038275, 0.001, 0}, 0}};
  shape.back = {Vector3d::Zero(), -Vector3d::UnitX(), Vector3d::UnitZ()};
  shape.slots[static_cast<std::size_t>(Slot::kFront)] =
      SlotFrame{{0.038775, 0, 0}, Vector3d::UnitX(), Vector3d::UnitZ()};
  return shape;
}

/// Origin at the back slot point, +x outward. The box starts 2.95 mm out.
ModuleShape MakeSensor() {
  ModuleShape shape;
  shape.parts = {
      {Part::kSensor, {0.0041, 0.031, 0.0155}, {0.005, 0, 0}, 0.003}};
  shape.back = {Vector3d::Zero(), -Vector3d::UnitX(), Vector3d::UnitY()};
  return shape;
}

}  // namespace

const ModuleShape& ShapeOf(ModuleType type) {
  static const ModuleShape core = MakeCore();
  static const ModuleShape brick = MakeBrick();
  static const ModuleShape joint = MakeJoint();
  static const ModuleShape sensor = MakeSensor();
  switch (type) {
    case ModuleType::kCore:
      return core;
    case ModuleType::kBrick:
      return brick;
    case ModuleType::kVerticalJoint:
    case ModuleType::kHorizontalJoint:
      return joint;
    case ModuleType::kTouchSensor:
      return sensor;
  }
  assert(false);
  return core;
}

}  // namespace plsc
