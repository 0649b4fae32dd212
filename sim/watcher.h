#pragma once

// Looks on while a life is simulated: for recordings (sim/pose_recorder) and
// for whoever waits. It sees the world but cannot change it, so that a life
// that is watched is the same bit for bit.

#include <cstdint>

#include "sim/options.h"
#include "sim/phenotype.h"

namespace plsc {

class World;

class Watcher {
 public:
  virtual ~Watcher() = default;

  /// Before a season that is simulated, `begin` s since birth.
  virtual void Begin(const Phenotype& robot, const SimulationOptions& options,
                     double begin) = 0;

  /// The world before its first step, 0, and after each one, 1, 2... Called a
  /// hundred thousand times a second: what is rare is for the watcher to tell.
  /// False ends the life (Outcome::kStopped).
  virtual bool See(const World& world, std::int64_t step) = 0;
};

}  // namespace plsc
