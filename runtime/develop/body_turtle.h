#pragma once

// The turtle that grows the body: the paper's module-reference and
// slot-reference (late development, I to V). Reads mounting commands, moving
// commands and modules; knows nothing of the network, but reports what it
// mounted so that the brain turtle can add a node.

#include <array>
#include <optional>
#include <vector>

#include "runtime/develop/effect.h"
#include "sim/body.h"

namespace plsc {

/// What became of a module: true when it was mounted.
struct Mounting {
  Effect effect = Effect::kMounted;
  int module = kNoModule;  ///< its index, when it was mounted

  explicit operator bool() const { return effect == Effect::kMounted; }
};

class BodyTurtle {
 public:
  /// Starts on a lone core, heading front. `max_modules` as in
  /// DevelopmentSettings; with `move_to_new` the module-reference follows each
  /// mounted brick or joint.
  BodyTurtle(int max_modules, bool move_to_new);

  /// A mounting command: overwrites the slot-reference (II).
  void SetSlot(Slot slot) { slot_reference_ = slot; }
  /// A module (III, IV). When it is not expressed the slot-reference is kept.
  Mounting Mount(ModuleType type) {
    if (!slot_reference_) return {Effect::kNoSlot};
    // Sensors are not counted, but none is mounted either once m is reached.
    if (size_ >= max_modules_) return {Effect::kBodyFull};
    return MountAt(TargetSlot(*slot_reference_), type);
  }
  /// Moving commands (V): kModuleReached, or why the reference stays. Moves
  /// other than kBack lead to a child, so the way back is the way to the core.
  Effect Move(Slot slot) {
    const int next = way(reference_, slot);
    const Effect effect =
        next == reference_ ? WhyNoWay(slot) : Effect::kModuleReached;
    reference_ = next;
    return effect;
  }

  const Body& body() const { return body_; }
  Body TakeBody() && { return std::move(body_); }

  // What an observer asks between symbols.
  int reference() const { return reference_; }  ///< index, the module-reference
  std::optional<Slot> slot_reference() const { return slot_reference_; }
  /// Where a module for `wanted` goes on the module-reference.
  Slot TargetSlot(Slot wanted) const;
  /// The module (no sensor) in the cell in front of that slot, or kNoModule.
  int NeighbourAt(Slot slot) const;

 private:
  struct Cell {
    int x = 0;
    int y = 0;
  };

  Module& at(int index) {
    return body_.modules[static_cast<std::size_t>(index)];
  }
  int& way(int module, Slot slot) {
    return ways_[static_cast<std::size_t>(module)]
                [static_cast<std::size_t>(slot)];
  }
  /// Pure, so that a reader that ignores effects does not ask.
  [[gnu::pure]] Effect WhyNoWay(Slot slot) const;
  void OpenWays(int index, const Module& module);
  Mounting MountAt(Slot slot, ModuleType type);
  static Cell CellAhead(const Module& from, Facing facing);
  int ModuleIn(Cell cell) const;

  Body body_;
  /// By module and Slot, where a move leads; the module itself when nowhere. A
  /// table, because whether a move succeeds is too hard to predict to branch.
  std::vector<std::array<int, kSlots>> ways_;
  int reference_ = 0;  ///< the module-reference
  std::optional<Slot> slot_reference_;
  int size_ = 1;  ///< modules without sensors
  int max_modules_;
  bool move_to_new_;
};

/// Roll of a module about its long axis relative to its parent, degrees: a
/// vertical joint is a joint rolled by 90, and what follows one is rolled
/// back, except another vertical joint.
int RollAngle(ModuleType child, ModuleType parent);

}  // namespace plsc
