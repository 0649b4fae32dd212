#pragma once

// The turtle that grows the body: the paper's module-reference and
// slot-reference (late development, I to V). Reads mounting commands, moving
// commands and modules; knows nothing of the network, but reports what it
// mounted so that the brain turtle can add a node.

#include <array>
#include <optional>
#include <vector>

#include "sim/body.h"

namespace plsc {

class BodyTurtle {
 public:
  /// Starts on a lone core, heading front. `max_modules` as in
  /// DevelopmentSettings; with `move_to_new` the module-reference follows each
  /// mounted brick or joint.
  BodyTurtle(int max_modules, bool move_to_new);

  /// A mounting command: overwrites the slot-reference (II).
  void SetSlot(Slot slot) { slot_reference_ = slot; }
  /// A module (III, IV). The index of the mounted module, or nothing when it
  /// is not expressed; then the slot-reference is kept.
  std::optional<int> Mount(ModuleType type);
  /// Moving commands (V).
  void MoveBack();
  void Move(Slot slot);

  const Body& body() const { return body_; }
  Body TakeBody() && { return std::move(body_); }

 private:
  struct Cell {
    int x = 0;
    int y = 0;
  };

  Module& at(int index) {
    return body_.modules[static_cast<std::size_t>(index)];
  }
  Slot TargetSlot(Slot wanted) const;
  bool IsTaken(Cell cell) const;

  Body body_;
  int reference_ = 0;           ///< the module-reference
  std::vector<int> came_from_;  ///< where move_back leads
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
