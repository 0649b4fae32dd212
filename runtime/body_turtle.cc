#include "runtime/body_turtle.h"

#include <algorithm>
#include <cassert>

namespace plsc {

BodyTurtle::BodyTurtle(int max_modules, bool move_to_new)
    : max_modules_(max_modules), move_to_new_(move_to_new) {
  Module core;
  core.number = 1;
  body_.modules.push_back(core);
}

int RollAngle(ModuleType child, ModuleType parent) {
  const bool child_is_vertical = child == ModuleType::kVerticalJoint;
  if (parent == ModuleType::kVerticalJoint) return child_is_vertical ? 0 : 270;
  return child_is_vertical ? 90 : 0;
}

// Where a module for `wanted` goes on the module-reference.
Slot BodyTurtle::TargetSlot(Slot wanted) const {
  const Module& reference = body_.modules[static_cast<std::size_t>(reference_)];
  if (IsJoint(reference.type)) return Slot::kFront;
  if (reference.type == ModuleType::kCore) {
    const auto is_taken = [&](Slot s) {
      return reference.child(s) != kNoModule;
    };
    // The core's back opens when its other three sides are taken, whatever
    // the command (IV).
    if (is_taken(Slot::kFront) && is_taken(Slot::kLeft) &&
        is_taken(Slot::kRight) && !is_taken(Slot::kBack))
      return Slot::kBack;
  }
  return wanted;
}

bool BodyTurtle::IsTaken(Cell cell) const {
  // At most max_modules cells, so a scan beats a set.
  return std::any_of(body_.modules.begin(), body_.modules.end(),
                     [&](const Module& module) {
                       return module.type != ModuleType::kTouchSensor &&
                              module.x == cell.x && module.y == cell.y;
                     });
}

std::optional<int> BodyTurtle::Mount(ModuleType type) {
  assert(type != ModuleType::kCore);
  if (!slot_reference_) return std::nullopt;
  // Sensors are not counted, but none is mounted either once m is reached.
  if (size_ >= max_modules_) return std::nullopt;
  const Slot slot = TargetSlot(*slot_reference_);
  const Module& parent = at(reference_);
  if (parent.child(slot) != kNoModule) return std::nullopt;

  Module module;
  module.type = type;
  module.parent = reference_;
  module.slot = slot;
  module.angle_deg = RollAngle(type, parent.type);
  if (type == ModuleType::kTouchSensor) {
    if (IsJoint(parent.type)) return std::nullopt;
  } else {
    // By Facing: front, left, back, right.
    constexpr std::array<Cell, 4> kAhead{Cell{0, 1}, Cell{-1, 0}, Cell{0, -1},
                                         Cell{1, 0}};
    module.facing = FacingOf(parent.facing, slot);
    const Cell ahead = kAhead[static_cast<std::size_t>(module.facing)];
    module.x = parent.x + ahead.x;
    module.y = parent.y + ahead.y;
    if (IsTaken({module.x, module.y})) return std::nullopt;
    module.number = ++size_;
  }

  const int index = static_cast<int>(body_.modules.size());
  at(reference_).children[static_cast<std::size_t>(slot)] = index;
  body_.modules.push_back(module);
  slot_reference_.reset();
  if (move_to_new_ && type != ModuleType::kTouchSensor) {
    came_from_.push_back(reference_);
    reference_ = index;
  }
  return index;
}

void BodyTurtle::MoveBack() {
  if (came_from_.empty()) return;
  reference_ = came_from_.back();
  came_from_.pop_back();
}

void BodyTurtle::Move(Slot slot) {
  assert(slot != Slot::kBack);
  const Module& reference = at(reference_);
  const Slot target = IsJoint(reference.type) ? Slot::kFront : slot;
  const int child = reference.child(target);
  if (child == kNoModule || at(child).type == ModuleType::kTouchSensor) return;
  came_from_.push_back(reference_);
  reference_ = child;
}

}  // namespace plsc
