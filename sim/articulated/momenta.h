#pragma once

// What moves without any force, and what it weighs: the robot's motion if its
// base rested and its servos held their speeds, the momenta that gravity and
// the last step leave to be made up for, and the inertia that resists.

#include <Eigen/Core>
#include <vector>

#include "sim/articulated/kinematics.h"
#include "sim/articulated/model.h"

namespace plsc::articulated {

/// Turning, then moving along, about the base's centre: a motion (rad/s, m/s)
/// or a momentum or impulse (kg m2/s, kg m/s).
struct Spatial {
  Eigen::Vector3d angular;
  Eigen::Vector3d linear;

  double dot(const Spatial& other) const {
    return angular.dot(other.angular) + linear.dot(other.linear);
  }
};

struct LinkMomenta {
  // The baseline: the base rests, joints turn at their targets.
  Eigen::Vector3d spin;      ///< rad/s
  Eigen::Vector3d velocity;  ///< m/s, of the centre of mass

  Symmetric inertia;  ///< kg m2, of the link, about its centre of mass

  // Of all that the joint moves, the link included; of the base: of all.
  double mass = 0;         ///< kg
  Eigen::Vector3d moment;  ///< kg m, sum of masses times places
  Symmetric about_base;    ///< kg m2, about the base's centre
  Spatial missing;         ///< momentum to be had beyond the baseline's

  // Of its joint.
  Spatial motion;    ///< of what it moves, at 1 rad/s
  Spatial momentum;  ///< of the same
  double aim = 0;    ///< kg m2/s, missing about its axis
};

/// `targets`, rad/s, and `momenta` by link; of the base the target is unused.
void Aim(const Model& model, const State& state,
         const std::vector<double>& targets, const Eigen::Vector3d& fall,
         double step, std::vector<LinkMomenta>& momenta);

/// 1 rad/s of joint a, told by the momentum of what joint b moves: an entry of
/// the mass matrix.
double Coupling(const Model& model, const std::vector<LinkMomenta>& momenta,
                int a, int b);

}  // namespace plsc::articulated
