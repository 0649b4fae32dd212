#pragma once

// 100 short lives in the articulated engine, whose final states are the same on
// every machine, however they are compiled. They are in
// tests/data/articulated_lives.txt; `cmake --build --preset release --target
// update_lives` files them anew.

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "sim/simulate.h"
#include "tests/sim/random_robot.h"
#include "tests/sim/terrains.h"

namespace plsc::test {

struct ShortLife {
  std::string name;  ///< "12 tilted"
  Phenotype robot;
  Terrain terrain;
  SimulationOptions options;
};

/// 50 robots of 3 to 17 modules, each on two of the grounds, every other one
/// with loops in its brain, every seventh with servos too weak for it.
inline std::vector<ShortLife> ShortLives() {
  constexpr const char* kNames[] = {"flat", "tilted", "rough", "steps",
                                    "obstacles"};
  const std::vector<Terrain> terrains = AllTerrains();
  std::mt19937 random(50);  // any
  std::vector<ShortLife> lives;
  for (int i = 0; i < 50; ++i) {
    Phenotype robot = RandomRobot(3 + i % 15, random);
    SimulationOptions options;
    options.duration = 2;
    options.start_height.reset();
    options.physics.engine = EngineKind::kArticulated;
    if (i % 2 == 0) {
      options.controller = ControllerMode::kCoupled;
      robot.brain.connections.push_back({0, 0, -0.6});
    }
    if (i % 7 == 3) options.servo.max_torque = 0.02;
    for (const int ground : {i % 5, (i + 1) % 5})
      lives.push_back({std::to_string(i) + ' ' + kNames[ground], robot,
                       terrains[static_cast<std::size_t>(ground)], options});
  }
  return lives;
}

inline std::uint64_t HashOf(const ShortLife& life) {
  // Among steps and obstacles, of which none are near the origin.
  const Onset onset{0, {1.3, 2.1, 0.7}, nullptr};
  return Live(life.robot, life.terrain, life.options, onset)
      .trajectory.state_hash;
}

}  // namespace plsc::test
