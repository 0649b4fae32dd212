#pragma once

// What is known of a season without simulating it: what the robot senses,
// what develops of it, and how that differs from the season before. Only
// whether the ground feels inclined must be known.

#include <map>
#include <optional>
#include <string>

#include "runtime/life/season_result.h"
#include "runtime/life/simulated.h"

namespace plsc {

struct DevelopedSeason {
  /// All but what is Simulated; the outcome is kUndeveloped
  /// when there is no robot.
  SeasonResult result;
  std::optional<Phenotype> robot;
};

/// Develops a life season by season. What it is given must outlive it, and what
/// the robot senses must be known (CheckSenses). `inherited`, if not empty, has
/// a value for every state and goes before what is sensed in the first season.
class SeasonDeveloper {
 public:
  SeasonDeveloper(const Genotype& genotype, const Scenario& scenario,
                  const Senses& inherited)
      : genotype_(genotype), scenario_(scenario), inherited_(inherited) {}

  bool is_over() const { return next_ == scenario_.seasons.size(); }
  const Season& season() const { return scenario_.seasons[next_]; }
  /// Whether the robot reads its IMU when the next season begins.
  bool AsksImu() const;
  /// The next season: `begin` in s since birth, `inclination` in rad, given if
  /// AsksImu().
  DevelopedSeason Next(double begin, std::optional<double> inclination);
  /// A season that the life did not reach.
  SeasonResult Skip();
  /// Of the season developed last.
  const std::optional<Phenotype>& robot() const { return robot_; }

 private:
  bool IsInherited() const { return next_ == 0 && !inherited_.empty(); }
  /// Body and brain of birth are kept.
  bool IsGrown() const;
  std::vector<SensedState> SenseNow(std::optional<double> inclination) const;
  SeasonResult Begin() const;
  void DescribeChange(const Phenotype& robot, SeasonResult& result) const;

  const Genotype& genotype_;
  const Scenario& scenario_;
  const Senses& inherited_;
  std::size_t next_ = 0;
  std::optional<Phenotype> robot_;   // of the season before
  std::vector<SensedState> sensed_;  // in the season before
};

/// What regulates a robot that senses this, of the genotype's states in their
/// order.
Environment EnvironmentOf(const std::vector<SensedState>& sensed,
                          const std::vector<State>& states);

/// A season developed and simulated; `developed` of a robot that developed.
/// Where what the season is worth comes to no number, that is its outcome.
SeasonResult Complete(SeasonResult developed, const Simulated& simulated,
                      const Season& season);

/// What was simulated of it.
Simulated SimulatedOf(const SeasonResult& result);

}  // namespace plsc
