#pragma once

// Fixed robots and the lives they live, whose final states must never change
// unnoticed. The states are in tests/data/state_hashes.json.

#include <cstdint>
#include <string>
#include <vector>

#include "sim/overlap.h"
#include "sim/simulate.h"
#include "tests/sim/authors_bodies.h"
#include "tests/sim/bodies.h"
#include "tests/sim/terrains.h"

namespace plsc::test {

/// One robot in one season.
struct GoldenLife {
  std::string name;  ///< "0 plastic plane, paper, tilted"
  Phenotype robot;
  Terrain terrain;
  SimulationOptions options;
};

/// Oscillators in all joints; of touch sensors, an input each, joined to all
/// oscillators; a loop on every other oscillator. So that coupling acts.
inline Phenotype WithSenses(const Body& body) {
  Phenotype robot = WithOscillators(body, 2.5, 1.7);
  Brain& brain = robot.brain;
  const int oscillators = static_cast<int>(brain.nodes.size());
  for (int i = 0; i < oscillators; i += 2)
    brain.connections.push_back({i, i, -0.6});
  for (std::size_t i = 0; i < body.modules.size(); ++i) {
    if (body.modules[i].type != ModuleType::kTouchSensor) continue;
    Node input;
    input.module = static_cast<int>(i);
    brain.nodes.push_back(input);
    const int source = static_cast<int>(brain.nodes.size()) - 1;
    for (int joint = 0; joint < oscillators; ++joint)
      brain.connections.push_back({source, joint, joint % 2 == 0 ? 0.4 : -0.4});
  }
  return robot;
}

/// What the two profiles do on a flat and on a sloping ground, at full length
/// of their differences, 2 s short.
inline SimulationOptions GoldenOptions(bool is_paper, bool is_tilted) {
  SimulationOptions options;
  options.duration = 2;
  if (is_paper) {
    options.controller = ControllerMode::kCoupled;
    options.start_height.reset();
    return options;
  }
  options.controller = ControllerMode::kOpenLoop;
  options.start_height = 0.1;
  options.servo.refresh = Refresh::kLate;
  if (is_tilted) {
    options.physics.step = 0.003;
    options.physics.solver = Solver::kIterative;
    options.physics.solver_iterations = 50;
  }
  return options;
}

/// Of the authors' bodies the first `kGoldenBodies` unlike ones that have three
/// joints or more and no overlap; in four seasons each.
inline constexpr int kGoldenBodies = 6;

inline std::vector<GoldenLife> GoldenLives() {
  std::vector<GoldenLife> lives;
  for (const nlohmann::json& entry : LoadAuthorsBodies()) {
    const Body body = BodyFromJson(entry.at("body"));
    // A robot that does not sense has one body for two environments.
    if (!lives.empty() && lives.back().robot.body == body) continue;
    const Assembly assembly = Assemble(body);
    if (assembly.hinges.size() < 3 || !FindOverlaps(assembly).empty()) continue;
    const std::string name = entry.at("case").get<std::string>();
    for (const bool is_paper : {true, false})
      for (const bool is_tilted : {false, true})
        lives.push_back({name + (is_paper ? ", paper" : ", published") +
                             (is_tilted ? ", tilted" : ", flat"),
                         WithSenses(body), is_tilted ? Slope(5) : Terrain{},
                         GoldenOptions(is_paper, is_tilted)});
    if (lives.size() == 4 * kGoldenBodies) break;
  }
  return lives;
}

inline std::uint64_t HashOf(const GoldenLife& life) {
  return Simulate(life.robot, life.terrain, life.options).state_hash;
}

}  // namespace plsc::test
