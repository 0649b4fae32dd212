#pragma once

// What came of one season: what the robot sensed, how it developed for it, what
// it did and its fitness; and of all seasons of a scenario.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/enum_names.h"
#include "runtime/develop/descriptors.h"
#include "runtime/scenario/scenario.h"
#include "sim/measures.h"
#include "sim/outcome.h"

namespace plsc {

/// Where a robot has a state's value from.
enum class SenseSource : std::uint8_t {
  kSeason,  ///< the scenario says so
  kImu,     ///< it felt it
  kParent,  ///< inherited: what its first parent sensed last
};

inline constexpr EnumNames<SenseSource, 3> kSenseSourceNames{
    {{SenseSource::kSeason, "season"},
     {SenseSource::kImu, "imu"},
     {SenseSource::kParent, "parent"}}};

/// Values of states by name, as a clause writes them.
using Senses = std::map<std::string, std::string>;

/// A state of the genotype and its value, as a clause writes it.
struct SensedState {
  std::string name;
  std::string value;
  SenseSource from = SenseSource::kSeason;

  friend bool operator==(const SensedState&, const SensedState&) = default;
};

/// What became of the robot at the start of a season.
enum class Change : std::uint8_t {
  kBorn,   ///< the first season
  kNone,   ///< the same body and brain as in the season before
  kBrain,  ///< the same body with another brain
  kBody,   ///< another body
};

inline constexpr EnumNames<Change, 4> kChangeNames{{{Change::kBorn, "born"},
                                                    {Change::kNone, "none"},
                                                    {Change::kBrain, "brain"},
                                                    {Change::kBody, "body"}}};

struct SeasonResult {
  std::string season;
  Profile profile = Profile::kPaper;
  Outcome outcome = Outcome::kCompleted;
  std::string reason;               ///< of the outcome; empty when completed
  double begin = 0;                 ///< s since birth; more than 0 only if the
                                    ///< robot lives on from another season
  std::vector<SensedState> sensed;  ///< at the start, by the genotype's states
  std::optional<double> inclination;  ///< rad, if the IMU was asked
  Change change = Change::kBorn;      ///< at the start
  std::string change_reason;  ///< "inclined False -> True"; what was sensed at
                              ///< birth
  BodyDescriptors body;
  BrainDescriptors brain;
  Behaviour behaviour;
  /// What the season's formula comes to, by default m/s (Eq. 2 of the paper);
  /// nothing when the life was not completed, which is worse than any number.
  std::optional<double> fitness;
  std::uint64_t state_hash = 0;  ///< of the final physical state
  std::int64_t steps = 0;        ///< simulated
  int solver_warnings = 0;       ///< failures of ODE's solver
};

struct Evaluation {
  std::vector<SeasonResult> seasons;  ///< in the scenario's order
};

/// Eq. 2: s if s > 0, s/10 if s < 0; -0.1 if s = 0 or the robot has no joint
/// at all (authors' program, fitness.py:65). `speed` in m/s.
double SeasonFitness(double speed, int hinge_count);

/// Of SeasonFitness: "2.66" cm/s; "penalty" of a robot that cannot move, or
/// does not, which is worth a number that is no speed; "none". Of an
/// experiment's own formula (`is_own`) the number as it is.
std::string FitnessText(const std::optional<double>& fitness,
                        bool is_own = false);
/// Whether that text is a speed.
bool IsSpeed(const std::optional<double>& fitness);

/// By season; with the unit, if they are speeds: "2.66 penalty cm/s".
std::string FitnessesText(const std::vector<std::optional<double>>& fitnesses,
                          bool is_own);

}  // namespace plsc
