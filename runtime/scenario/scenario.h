#pragma once

// What robots live through: seasons, each with its ground, its duration, its
// physics and what a robot is told there, and what they share. Read from YAML
// (scenario_yaml.h). The values of what a file leaves out are its profile's
// (runtime/scenario/scenario_profile.h).

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/genotype.h"
#include "grammar/enum_names.h"
#include "grammar/result.h"
#include "runtime/formula/formula.h"
#include "sim/measures.h"
#include "sim/options.h"
#include "sim/terrain.h"

namespace plsc {

/// A named set of values. Every one of them is a key of the scenario, too.
enum class Profile : std::uint8_t {
  kPaper,      ///< what the paper's text says
  kPublished,  ///< what the authors' program ran
  kSwift,      ///< kPaper, with the articulated engine
};
inline constexpr EnumNames<Profile, 3> kProfileNames{
    {{Profile::kPaper, "paper"},
     {Profile::kPublished, "published"},
     {Profile::kSwift, "swift"}}};

enum class Lives : std::uint8_t {
  /// Each season is lived from a fresh start at the origin.
  kIndependent,
  /// One life: the robot stays where it is, redevelops there if it senses
  /// something else, and lives on.
  kContinuous,
};

/// When a robot develops (paper, "Conclusions", future work).
enum class Plasticity : std::uint8_t {
  kLifelong,       ///< for what it senses in each season
  kMorphogenesis,  ///< once, for what it senses at birth
};

/// Where `inclined` comes from if a season does not give it.
enum class Sensing : std::uint8_t {
  kImu,    ///< from the core's IMU (sim/imu)
  kGiven,  ///< from nowhere: every season must give it
};

struct Season {
  std::string name;
  Terrain terrain;
  double duration = 50;  ///< s
  /// As SimulationOptions: m, or nothing for a start at rest on the ground.
  std::optional<double> start_height;
  PhysicsOptions physics;
  /// What a robot is told, by state name, as written in a clause: "True",
  /// "30.5", "wet". May name states that a genotype does not ask about.
  std::map<std::string, std::string> senses;
  /// What a robot is worth that lived the season; nothing: what the authors'
  /// program has, DefaultFitness.
  std::optional<Formula> fitness;

  friend bool operator==(const Season&, const Season&) = default;
};

struct Scenario {
  std::string name;
  Profile profile = Profile::kPaper;
  Lives lives = Lives::kIndependent;
  Plasticity plasticity = Plasticity::kLifelong;
  std::vector<Season> seasons;
  double sample_interval = 0.2;   ///< s
  double start_clearance = 1e-4;  ///< m, of a start at rest
  ControllerMode controller = ControllerMode::kCoupled;
  MeasuredPoint measured = MeasuredPoint::kMassCentre;
  Sensing sensing = Sensing::kImu;
  ImuOptions imu;
  int max_steps = 1000000;  ///< of a season
  int max_links = 256;      ///< of a robot
  ServoOptions servo;
  /// Places that robots may be meant to reach, in all seasons. They are seen
  /// and measured, and change nothing.
  std::vector<Target> targets;

  friend bool operator==(const Scenario&, const Scenario&) = default;
};

/// What a robot with these states senses in the season: what the season gives,
/// else what the robot felt ("inclined" to "True"). An error names each state
/// that has no value, or one of the wrong type.
Result<Environment> Sense(const Season& season,
                          const std::vector<State>& states,
                          const std::map<std::string, std::string>& felt = {});

/// States that robots can feel by themselves in the season, which so need not
/// be given: a bool of the name "inclined", if the IMU is asked.
bool IsFelt(const Scenario& scenario, const Season& season, const State& state);

/// The errors of Sense for all seasons, what robots feel taken as known.
std::vector<Diagnostic> CheckSenses(const Scenario& scenario,
                                    const std::vector<State>& states);

/// All seasons are worth what the authors' program has.
Scenario WithoutFitness(Scenario scenario);

/// What keeps the seasons' engines from living them, for a message; or nothing.
/// The articulated engine knows no iterative solver, and one life has one
/// engine.
std::optional<Diagnostic> CheckEngines(const Scenario& scenario);

/// Gives all seasons the engine; what CheckEngines has to say of that.
std::optional<Diagnostic> SetEngine(Scenario& scenario, EngineKind engine);

/// Whether ODE lives any of the seasons.
bool UsesOde(const Scenario& scenario);

/// How a robot is simulated in a season of the scenario.
SimulationOptions OptionsFor(const Scenario& scenario, const Season& season);

}  // namespace plsc
