#pragma once

// What happens to a season beside what its options say: where exactly the body
// is put down, how slippery the ground is, how its sensors and motors err. A
// plain value; whoever wants chance draws it and hands it in, so that a life
// stays a function of its arguments. The default disturbs nothing.

#include <cstdint>

#include "sim/lattice_noise.h"

namespace plsc {

/// Errors that are drawn anew at every update of the controller, each a
/// function of the seed, the update and the part alone.
struct Noise {
  double amplitude = 0;
  std::uint64_t seed = 0;

  friend bool operator==(const Noise&, const Noise&) = default;
};

struct Disturbance {
  // Of a body that is put down; one that lives on keeps its place.
  double lift = 0;  ///< m, at least 0, above where the options put it
  double shift_x = 0, shift_y = 0;  ///< m
  double yaw = 0;                   ///< rad, counter-clockwise
  double friction = 1;  ///< factor of PhysicsOptions::friction, more than 0
  /// rad, by which the inclination that is felt is off (FeltWith).
  double lean = 0;
  Noise touch;  ///< probability that a touch sensor's reading is the other one
  Noise motor;  ///< rad, by which a servo's target is off at most

  friend bool operator==(const Disturbance&, const Disturbance&) = default;
};

/// Whether a sensor reads the contrary of what it touches; `update` counts from
/// the season's start, `module` is an index into Body::modules.
inline bool IsFlipped(const Noise& touch, std::int64_t update, int module) {
  return LatticeNoise(touch.seed, update, module, 0) < touch.amplitude;
}

/// rad, from -amplitude to amplitude, each as likely.
inline double TargetError(const Noise& motor, std::int64_t update, int joint) {
  return motor.amplitude * (2 * LatticeNoise(motor.seed, update, joint, 0) - 1);
}

}  // namespace plsc
