#pragma once

// Pairs of boxes that nearly touch or do, drawn from a seed. Of numbers only
// sums, products and roots, so that all machines draw the same.

#include <cstdint>

#include "sim/articulated/box_contact.h"

namespace plsc::test {

/// How the sides of the boxes lie to each other.
enum class Turned : std::uint8_t {
  kFreely,
  kAboutOneSide,   ///< parallel edges to rounding, as on both sides of a hinge
  kByRightAngles,  ///< all edges
  kNearRightAngles,  ///< slanted by 1e-9 to 1e-2
};

struct BoxPose {
  OrientedBox first, second;
  Turned turned;
};

class RandomBoxes {
 public:
  explicit RandomBoxes(std::uint64_t seed) : state_(seed) {}

  /// Sizes of modules' boxes or any from 1 mm to 10 cm; along a random way from
  /// centre to centre, a third apart, the others up to 2 cm into each other and
  /// mostly by far less; never at one centre, where there is no way out.
  BoxPose Next();
  /// One, turned in any way, at the origin.
  OrientedBox NextBox();

  std::uint64_t Bits();
  double Uniform(double low, double high);
  /// Uniform on the sphere.
  void Direction(double (&direction)[3]);
  /// Any rotation; its columns one after the other.
  void Rotation(double (&axes)[3][3]);

 private:
  void Size(OrientedBox& box);
  void Turn(BoxPose& pose);

  std::uint64_t state_;
};

/// The box as it lies after a motion: turned about the origin, then shifted.
OrientedBox Moved(const OrientedBox& box, const double (&axes)[3][3],
                  const double (&shift)[3]);

}  // namespace plsc::test
