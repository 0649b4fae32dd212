#pragma once

// Random robots at work in the articulated engine, step by step and open to
// view.

#include <cmath>
#include <memory>
#include <random>

#include "sim/articulated/articulated_engine.h"
#include "sim/assembly.h"
#include "sim/placement.h"
#include "tests/sim/random_robot.h"
#include "tests/sim/terrains.h"

namespace plsc::test {

/// rad, to which joints turn at most while servos can: less than their usual
/// range, as a servo that leaves a stop does so with all its torque (ODE's
/// law), which may fling a light module away.
inline constexpr double kSwing = 0.7;

/// A robot whose servos all go back and forth, out of time.
class Driven {
 public:
  Driven(const Body& body, const Terrain& ground,
         const SimulationOptions& chosen)
      : assembly(Assemble(body)),
        terrain(ground),
        options(chosen),
        engine({assembly, terrain, options,
                StartOf(assembly, terrain, options, {})}) {}

  int links() const { return static_cast<int>(assembly.links.size()); }
  int joints() const { return links() - 1; }
  /// rad/s. New targets come at 8 Hz, about as those of brains.
  double TargetOf(int joint) const {
    const double time = (steps - steps % 25) * options.physics.step;
    const double rate = 1.5 + 0.1 * (joint % 16);
    return kSwing / 2 * rate * std::cos(time * rate + 2.1 * joint);
  }
  bool Step() {
    for (int joint = 0; joint < joints(); ++joint)
      engine.SetJointSpeed(joint, TargetOf(joint));
    ++steps;
    return engine.Step();
  }

  Assembly assembly;
  Terrain terrain;
  SimulationOptions options;
  articulated::ArticulatedEngine engine;
  int steps = 0;
};

inline SimulationOptions Articulated() {
  SimulationOptions options;
  options.physics.engine = EngineKind::kArticulated;
  options.start_height.reset();
  return options;
}

}  // namespace plsc::test
