#pragma once

// Writes a Trajectory while a World moves.

#include <Eigen/Core>

#include "sim/trajectory.h"

namespace plsc {

class World;

/// Rotations about the fixed x, y, z axes, in this order, that give `axes`;
/// |pitch| <= pi/2.
Eigen::Vector3d RollPitchYaw(const Eigen::Matrix3d& axes);

class Recorder {
 public:
  Recorder(const World& world, Eigen::Index samples, double interval);

  /// `time` in s since birth. At most as many as announced.
  void Sample(const World& world, double time);

  /// What was sampled, however little it is, and how the world fared.
  Trajectory Finish(const World& world, std::int64_t steps);

 private:
  Trajectory trajectory_;
  Eigen::Index count_ = 0;
};

}  // namespace plsc
