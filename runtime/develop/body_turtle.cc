// Late development of the body (paper, "Mapping stage 2", I to V; authors'
// program, plasticoding.py: moves 311-347, the grid 484-524, mounting 526-580).
// One turtle stands on a module (reference_) with at most one pending slot.
// From a joint every move leads to its front but the one back, which leads
// home: there the program is followed, as the paper has all of them go to the
// front and nobody would ever come back.
//
// What holds at all times: modules are numbered in the order of mounting,
// parents before children; no two modules but sensors share a cell; and `ways_`
// has, for each module and side, where a move leads, the module itself where it
// leads nowhere. The table is kept when a module is mounted, which is seldom,
// so that a move is one look, without a branch that nobody could predict.
//
// A module that cannot be mounted leaves everything as it was, the pending slot
// included: the next module is tried in the same place. To clear it would be
// another grammar. Mounting looks through all cells, at most max_modules and
// their sensors; all else is constant time.

#include "runtime/develop/body_turtle.h"

#include <array>
#include <cassert>

namespace plsc {

BodyTurtle::BodyTurtle(int max_modules, bool move_to_new)
    : max_modules_(max_modules), move_to_new_(move_to_new) {
  // The paper's 15 modules; one allocation instead of five. Sensors and larger
  // bodies grow on.
  constexpr std::size_t kUsualModules = 16;
  body_.modules.reserve(kUsualModules);
  ways_.reserve(kUsualModules);
  Module core;
  core.number = 1;
  body_.modules.push_back(core);
  ways_.push_back({0, 0, 0, 0});
}

int RollAngle(ModuleType child, ModuleType parent) {
  const bool child_is_vertical = child == ModuleType::kVerticalJoint;
  if (parent == ModuleType::kVerticalJoint) return child_is_vertical ? 0 : 270;
  return child_is_vertical ? 90 : 0;
}

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

BodyTurtle::Cell BodyTurtle::CellAhead(const Module& from, Facing facing) {
  // By Facing: front, left, back, right.
  static constexpr std::array<Cell, 4> kAhead{Cell{0, 1}, Cell{-1, 0},
                                              Cell{0, -1}, Cell{1, 0}};
  const Cell ahead = kAhead[static_cast<std::size_t>(facing)];
  return {from.x + ahead.x, from.y + ahead.y};
}

int BodyTurtle::ModuleIn(Cell cell) const {
  // At most max_modules cells, so a scan beats a set.
  for (std::size_t i = 0; i < body_.modules.size(); ++i) {
    const Module& module = body_.modules[i];
    if (module.x == cell.x && module.y == cell.y &&
        module.type != ModuleType::kTouchSensor)
      return static_cast<int>(i);
  }
  return kNoModule;
}

int BodyTurtle::NeighbourAt(Slot slot) const {
  const Module& reference = body_.modules[static_cast<std::size_t>(reference_)];
  return ModuleIn(CellAhead(reference, FacingOf(reference.facing, slot)));
}

Mounting BodyTurtle::MountAt(Slot slot, ModuleType type) {
  assert(type != ModuleType::kCore);
  const Module& parent = at(reference_);
  // What returns before the module is numbered leaves the turtle as it was.
  if (parent.child(slot) != kNoModule) return {Effect::kSlotTaken};

  Module module;
  module.type = type;
  module.parent = reference_;
  module.slot = slot;
  module.angle_deg = RollAngle(type, parent.type);
  if (type == ModuleType::kTouchSensor) {
    if (IsJoint(parent.type)) return {Effect::kSensorOnJoint};
  } else {
    module.facing = FacingOf(parent.facing, slot);
    const Cell cell = CellAhead(parent, module.facing);
    if (ModuleIn(cell) != kNoModule) return {Effect::kCellTaken};
    module.x = cell.x;
    module.y = cell.y;
    module.number = ++size_;
  }

  const int index = static_cast<int>(body_.modules.size());
  at(reference_).children[static_cast<std::size_t>(slot)] = index;
  OpenWays(index, module);
  body_.modules.push_back(module);
  slot_reference_.reset();
  if (move_to_new_ && type != ModuleType::kTouchSensor) reference_ = index;
  return {Effect::kMounted, index};
}

// Sensors cannot be moved to. Nothing is known of the slots of `module` yet.
// No command leads to a child at the core's back: moves are to the front, left
// and right, and back is the way home.
void BodyTurtle::OpenWays(int index, const Module& module) {
  ways_.push_back({module.parent, index, index, index});
  if (module.type == ModuleType::kTouchSensor) return;
  const bool is_on_joint = IsJoint(at(module.parent).type);
  for (const Slot side : {Slot::kFront, Slot::kRight, Slot::kLeft})
    if (is_on_joint || side == module.slot) way(module.parent, side) = index;
}

Effect BodyTurtle::WhyNoWay(Slot slot) const {
  if (slot == Slot::kBack) return Effect::kAtStart;
  const Module& reference = body_.modules[static_cast<std::size_t>(reference_)];
  const Slot target = IsJoint(reference.type) ? Slot::kFront : slot;
  return reference.child(target) == kNoModule ? Effect::kSideEmpty
                                              : Effect::kSensorThere;
}

}  // namespace plsc
