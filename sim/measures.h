#pragma once

// Behavioural descriptors of a season (paper, "Behavioral descriptors"; named
// as in the authors' program, measures.py, without its errors in durations
// and windows). Computed from samples; knows no body but its size.

#include <cstdint>

#include "sim/trajectory.h"

namespace plsc {

/// Whose way the speeds tell.
enum class MeasuredPoint : std::uint8_t {
  kMassCentre,  ///< of the whole robot (paper, "Behavioral descriptors")
  kCore,  ///< the core's centre (authors' program, WorldController.cpp:153)
};

/// All zero, with is_valid false, for a trajectory that was not completed.
struct Behaviour {
  bool is_valid = false;
  double displacement_velocity_hill = 0;  ///< m/s, the paper's Speed: progress
                                          ///< along +y (the paper's x)
  double displacement_velocity = 0;       ///< m/s, straight, in the xy plane
  double velocity = 0;      ///< m/s, along the path in the xy plane
  double head_balance = 0;  ///< 0.25 to 1, the paper's Balance (Eq. 4)
  double contacts = 0;      ///< mean contact points a sample over Size
};

/// `size`: modules that are no sensors, at least 1.
Behaviour Measure(const Trajectory& trajectory, int size, MeasuredPoint point);

}  // namespace plsc
