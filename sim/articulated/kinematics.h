#pragma once

// Where the links are and how they move. Ground axes throughout: z is the
// normal of the ground's plane, x the world's; places are relative to the
// base's centre of mass, so that a robot far from the origin is as exact.

#include <Eigen/Geometry>
#include <vector>

#include "sim/articulated/model.h"

namespace plsc::articulated {

/// 3 x 3, symmetric.
struct Symmetric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  Eigen::Vector3d operator*(const Eigen::Vector3d& v) const {
    return {xx * v.x() + xy * v.y() + xz * v.z(),
            xy * v.x() + yy * v.y() + yz * v.z(),
            xz * v.x() + yz * v.y() + zz * v.z()};
  }
  void operator+=(const Symmetric& other) {
    xx += other.xx, xy += other.xy, xz += other.xz;
    yy += other.yy, yz += other.yz, zz += other.zz;
  }
};

/// The columns of `axes` turn what is in link axes out.
Symmetric TurnedOut(const Eigen::Matrix3d& axes,
                    const Eigen::Matrix3d& inertia);

struct LinkState {
  /// columns: of the link
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  /// m, its centre of mass, from the base's
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  /// unit, direction of its joint's axis
  Eigen::Vector3d hinge = Eigen::Vector3d::Zero();
  /// m, of its joint, from the base's centre
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();
  double angle = 0;  ///< rad, of its joint
  double speed = 0;  ///< rad/s, of its joint in the last step

  // As the last step left them, at the pose before.
  /// m/s
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  /// rad/s
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();

  // What it carries on (sim/articulated/momenta).
  /// m/s, momentum per mass
  Eigen::Vector3d carried = Eigen::Vector3d::Zero();
  /// m, from where it is to where that acts
  Eigen::Vector3d drift = Eigen::Vector3d::Zero();
  /// m/s, by which joints bend its way in a step
  Eigen::Vector3d bend = Eigen::Vector3d::Zero();
  /// kg m2/s, momentum of spin
  Eigen::Vector3d turning = Eigen::Vector3d::Zero();
  /// kg m2/s, what half a step turns of it
  Eigen::Vector3d gyration = Eigen::Vector3d::Zero();
};

struct State {
  Eigen::Vector3d base;       ///< m, the base's centre of mass
  Eigen::Quaterniond turned;  ///< ground axes to the base's
  Eigen::Vector3d moment;     ///< kg m, sum of masses times places
  std::vector<LinkState> links;
};

/// Axes, places, hinges and anchors of all links, and the moment, from the
/// base's turn and the angles.
void Place(const Model& model, State& state);

/// The base's pose and all angles that fit the poses of links best: axes by
/// link, ground axes. Places of other links follow.
void Fit(const Model& model, const std::vector<Eigen::Matrix3d>& axes,
         State& state);

}  // namespace plsc::articulated
