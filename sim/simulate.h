#pragma once

// One season: a phenotype on a terrain, from a fresh start or living on.

#include <vector>

#include "sim/disturbance.h"
#include "sim/options.h"
#include "sim/phenotype.h"
#include "sim/placement.h"
#include "sim/terrain.h"
#include "sim/trajectory.h"
#include "sim/watcher.h"
#include "sim/world.h"

namespace plsc {

/// A robot in mid-life: what one season leaves and the next takes up.
struct LifeState {
  double time = 0;                  ///< s since birth
  Placement core;                   ///< of the core's centre
  std::vector<LinkPose> poses;      ///< by link
  std::vector<LinkMotion> motions;  ///< by link
  std::vector<double> memory;       ///< Controller::memory
};

/// How a robot comes into a season.
struct Onset {
  double time = 0;  ///< s since birth, at which oscillators go on
  Spot spot = {};   ///< where a fresh body is put
  /// The very body lives on: it keeps poses, speeds and memory; `spot` and
  /// `time` are its own. Of a life with the same phenotype, on the same
  /// ground (sim/passage takes it from another).
  const LifeState* carried = nullptr;
  Disturbance disturbance = {};
};

struct Lived {
  Trajectory trajectory;
  LifeState end;  ///< of completed lives
};

/// A pure function of its arguments: the same bits on every call, whatever was
/// simulated before and in whatever thread. Robots without joints are
/// simulated, too (they fall and rest). Not simulated, and without samples, is
/// a robot that overlaps in the rest pose (kOverlapping) or has too many links
/// (kTooLarge), and a life of no step or too many (kOutOfSteps). The watcher,
/// if any, sees every step and may end the life (kStopped).
Lived Live(const Phenotype& phenotype, const Terrain& terrain,
           const SimulationOptions& undisturbed, const Onset& onset,
           Watcher* watcher = nullptr);

/// From a fresh start at the origin.
Trajectory Simulate(const Phenotype& phenotype, const Terrain& terrain,
                    const SimulationOptions& options);

}  // namespace plsc
