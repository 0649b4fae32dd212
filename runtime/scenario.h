#pragma once

// What robots live through: seasons, each with its ground, its duration and
// what a robot senses there, and the physics they share. Read from YAML
// (runtime/scenario.cc is one of the two places that know YAML).

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/genotype.h"
#include "grammar/result.h"
#include "sim/options.h"
#include "sim/terrain.h"

namespace plsc {

/// Where robots start, m, core's centre above the origin: as the authors
/// configured it for each ground (authors' program, plastic_big.py:35).
inline constexpr double kFlatStartHeight = 0.03;
inline constexpr double kTiltedStartHeight = 0.1;

struct Season {
  std::string name;
  Terrain terrain;
  double duration = 50;                    ///< s
  double start_height = kFlatStartHeight;  ///< m
  /// What a robot senses, by state name, as written in a clause: "True",
  /// "30.5", "wet". May name states that a genotype does not ask about.
  std::map<std::string, std::string> senses;

  friend bool operator==(const Season&, const Season&) = default;
};

struct Scenario {
  std::string name;
  std::vector<Season> seasons;
  double sample_interval = 0.2;  ///< s
  ControllerMode controller = ControllerMode::kOpenLoop;
  PhysicsOptions physics;
  ServoOptions servo;

  friend bool operator==(const Scenario&, const Scenario&) = default;
};

/// The paper's: 50 s Flat, then 50 s Tilted by 5 degrees, where `inclined` is
/// sensed; `hot` is False in both.
Scenario PaperScenario();

/// Unknown keys, wrong types and wrong units are errors with their place.
Result<Scenario> ParseScenario(const Source& yaml);

/// The whole scenario as YAML, every constant written out; ParseScenario
/// returns an equal one.
std::string PrintScenario(const Scenario& scenario);

/// What a robot with these states senses in the season; an error names each
/// state for which the season has no value, or one of the wrong type.
Result<Environment> Sense(const Season& season,
                          const std::vector<State>& states);

}  // namespace plsc
