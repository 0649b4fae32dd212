#pragma once

// The parts kit: of which boxes each kind of module is made, what they weigh,
// where further modules fasten. One table, taken from the authors' program
// (Revolve, commit ae99a098, revolve_module.py:209-432); the paper gives no
// sizes. Frames are the module's own; sim/assembly puts them together.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/body.h"

namespace plsc {

enum class Part : std::uint8_t {
  kCore,
  kBrick,
  kFrame,   ///< of a joint; rigid with the parent module
  kServo,   ///< of a joint; moves with what the joint carries
  kPlate,   ///< of a joint, where the next module fastens; moves likewise
  kSensor,  ///< touch sensor; rigid with its module
};

/// A solid box, its sides along the module's axes.
struct PartShape {
  Part part = Part::kCore;
  Eigen::Vector3d size;    ///< m, full lengths of the sides
  Eigen::Vector3d centre;  ///< m, in the module's frame
  double mass = 0;         ///< kg
};

/// Where modules fasten: a child's back slot point comes to lie on its
/// parent's slot point, the normals oppose, the tangents agree (once the
/// child's is turned by Module::angle_deg).
struct SlotFrame {
  Eigen::Vector3d point;    ///< m
  Eigen::Vector3d normal;   ///< unit, outward
  Eigen::Vector3d tangent;  ///< unit, up on an upright module
};

struct ModuleShape {
  std::vector<PartShape> parts;
  SlotFrame back;  ///< by which it hangs on its parent; the core's is unused
  std::array<std::optional<SlotFrame>, kSlots> slots;  ///< for children
};

/// Both joints share a shape: they differ by the roll in Module::angle_deg.
const ModuleShape& ShapeOf(ModuleType type);

/// m, from a joint's back slot point along its x axis to its hinge.
inline constexpr double kHingeOffset = 0.01565;

/// True for the parts of a joint that lie beyond its hinge.
inline bool IsMovedByJoint(Part part) {
  return part == Part::kServo || part == Part::kPlate;
}

}  // namespace plsc
