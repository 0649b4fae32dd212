#pragma once

// A developed morphology: modules on a grid, the core first. What the turtle
// of late development builds and what the simulator assembles. Knows no
// physics (sim/assembly) and no language.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plsc {

enum class ModuleType : std::uint8_t {
  kCore,
  kBrick,
  kVerticalJoint,    ///< A1: axis of rotation vertical (authors' AJ2)
  kHorizontalJoint,  ///< A2: axis of rotation horizontal (authors' AJ1)
  kTouchSensor,
};

inline bool IsJoint(ModuleType type) {
  return type == ModuleType::kVerticalJoint ||
         type == ModuleType::kHorizontalJoint;
}

/// The authors' numbering, which also appears in sensor ids ("1s2"). Core and
/// brick have all four (a brick's back is its attachment), a joint only
/// kFront, a sensor none.
enum class Slot : std::uint8_t { kBack = 0, kFront = 1, kRight = 2, kLeft = 3 };
inline constexpr int kSlots = 4;

/// Absolute direction of a module's own front, seen from above with the
/// core's front up; counter-clockwise, so that a left slot adds 1.
enum class Facing : std::uint8_t {
  kFront = 0,  ///< +y
  kLeft = 1,   ///< -x
  kBack = 2,   ///< -y
  kRight = 3,  ///< +x
};

/// The direction in which `slot` of a module with `facing` points.
Facing FacingOf(Facing facing, Slot slot);
Facing Opposite(Facing facing);

inline constexpr int kNoModule = -1;

struct Module {
  ModuleType type = ModuleType::kCore;
  int parent = kNoModule;   ///< index into Body::modules
  Slot slot = Slot::kBack;  ///< of the parent, where this module sits
  std::array<int, kSlots> children{kNoModule, kNoModule, kNoModule, kNoModule};
  Facing facing = Facing::kFront;
  int x = 0;          ///< cell, + to the core's right; sensors take no cell
  int y = 0;          ///< cell, + to the core's front
  int angle_deg = 0;  ///< roll about the long axis relative to the parent:
                      ///< 0, 90 or 270
  int number = 0;     ///< 1 the core, 2, 3... in order of mounting; sensors 0

  int child(Slot s) const { return children[static_cast<std::size_t>(s)]; }

  friend bool operator==(const Module&, const Module&) = default;
};

/// In order of mounting; modules[0] is the core, parents precede children.
struct Body {
  std::vector<Module> modules;

  friend bool operator==(const Body&, const Body&) = default;
};

/// The paper's name of a module's symbol.
inline constexpr std::array<std::pair<ModuleType, std::string_view>, 5>
    kModuleNames{{{ModuleType::kCore, "C"},
                  {ModuleType::kBrick, "B"},
                  {ModuleType::kVerticalJoint, "A1"},
                  {ModuleType::kHorizontalJoint, "A2"},
                  {ModuleType::kTouchSensor, "T"}}};
std::string_view ModuleName(ModuleType type);

/// "1" the core, "2"...; a sensor: its parent's id, "s", the slot's digit.
std::string ModuleId(const Body& body, int index);

}  // namespace plsc
