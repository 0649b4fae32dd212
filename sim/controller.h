#pragma once

// A Brain at work: from time and touch to what every servo strives for. Runs
// at ServoOptions::update_rate, far slower than the physics. Knows no ODE; the
// joint speeds it leads to are held by sim/world in between.

#include <vector>

#include "sim/brain.h"
#include "sim/options.h"
#include "sim/phenotype.h"

namespace plsc {

/// What a servo takes; a hair inside 0 and 1 as in the authors' program
/// (PositionMotor.cpp:95), so that targets stay inside the joint's stops.
inline constexpr double kMinOutput = 1e-5;
inline constexpr double kMaxOutput = 0.99999;

/// Of an oscillator at phase 0, and of a joint that has none.
inline constexpr double kRestOutput = 0.5;

/// Eq. 1 of the paper: a sine of `amplitude` about 0.5, not clamped; `time` in
/// s since birth. Not a number where the period is 0, which only genotypes out
/// of their range have: their robots end as unstable.
double Oscillate(const Node& oscillator, double time);

/// The servo: rad/s to strive for at `angle` (rad), given a node's output. The
/// output picks a target between the limits, 0.5 the middle; speed is in
/// proportion to the error, up to max_speed. So it lags about 1.1 s behind,
/// and evolution reckons with that (authors' program, PositionMotor.cpp:95).
double ServoSpeed(double output, double angle, const ServoOptions& servo);

class Controller {
 public:
  Controller(const Phenotype& phenotype, ControllerMode mode);

  /// One update. `touched` by Body::modules. Gives the outputs by joint, in
  /// the order of Body::modules, valid until the next update; 0.5 for a joint
  /// without oscillator.
  const std::vector<double>& Update(double time,
                                    const std::vector<bool>& touched);

  /// What loops remember: the latest output by node, 0.5 before the first.
  const std::vector<double>& memory() const { return previous_; }
  /// As another controller of the same brain had it.
  void Remember(std::vector<double> memory);

 private:
  double Coupled(std::size_t node, double free_output,
                 const std::vector<bool>& touched) const;

  Brain brain_;
  ControllerMode mode_;
  std::vector<int> joint_of_node_;  ///< kNoModule for inputs
  std::size_t joints_ = 0;
  std::vector<double> previous_;
  std::vector<double> outputs_;  ///< kept: a step asks for no memory
};

}  // namespace plsc
