#pragma once

// What a simulated life leaves behind.

#include <Eigen/Core>
#include <cstdint>
#include <string>

#include "sim/outcome.h"

namespace plsc {

/// Sampled every `interval`, the start and the end included.
struct Trajectory {
  Outcome outcome = Outcome::kCompleted;
  std::string reason;                 ///< why, in words; empty when completed
  double interval = 0.2;              ///< s, between samples
  Eigen::VectorXd time;               ///< s since birth, (samples)
  Eigen::Matrix3Xd core_position;     ///< m, world frame, (3 x samples)
  Eigen::Matrix3Xd core_orientation;  ///< rad, roll pitch yaw: rotations about
                                      ///< the fixed x, y, z axes in this order,
                                      ///< |pitch| <= pi/2, (3 x samples)
  Eigen::Matrix3Xd mass_centre;       ///< m, of the whole robot, (3 x samples)
  Eigen::MatrixXd joint_angle;        ///< rad, (joints x samples), joints in
                                      ///< the order of Body::modules
  Eigen::VectorXi contacts;           ///< contact points, (samples)
  std::int64_t steps = 0;             ///< simulated
  int solver_warnings = 0;            ///< ODE's "LCP internal error"
  std::uint64_t state_hash = 0;       ///< of the final state, bit for bit
  /// rad/s, over all steps and joints: by how much joints turn otherwise than
  /// their servos are told (sim/servo_errors).
  double servo_error_median = 0;
  double servo_error_worst = 0;
  double energy = 0;  ///< J: work of the servos, whichever way it went
  double weight = 0;  ///< N, of the whole robot
};

}  // namespace plsc
