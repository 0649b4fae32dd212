#pragma once

// Single robots of a run, for a report: the best one with its body in every
// season, and what regulates the last population.

#include <optional>
#include <string>
#include <vector>

#include "runtime/life/season_result.h"
#include "runtime/store/run_store.h"

namespace plsc {

struct SeasonPortrait {
  std::string season;
  Outcome outcome = Outcome::kCompleted;
  std::optional<double> speed;    ///< m/s; nothing unless completed
  std::optional<double> balance;  ///< likewise
  int size = 0;                   ///< modules without sensors; 0: no robot
  Change change = Change::kBorn;
  std::vector<SensedState> sensed;  ///< empty if it senses nothing
  std::string svg;  ///< the body from above; empty if there is none
};

/// A rule, and in which seasons its clause held.
struct RuleUse {
  std::string symbol;         ///< that it replaces
  std::string clause;         ///< "inclined = True"; empty: it always holds
  std::vector<bool> is_held;  ///< by season
};

struct Portrait {
  int id = 0;
  std::string name;
  int born = 0;               ///< generation
  std::vector<State> states;  ///< that it can sense
  std::vector<SeasonPortrait> seasons;
  std::vector<RuleUse> rules;  ///< in the genotype's order
};

/// Of a robot that is evaluated. Bodies are developed anew for what the robot
/// sensed; where this program develops another body than is stored, there is
/// no picture.
Expected<Portrait, Failure> PortraitOf(RunStore& store, int id);

/// How many rules of robots are alike: of one symbol, with one clause, held in
/// the same seasons.
struct RuleCount {
  RuleUse rule;
  int count = 0;
};

/// All rules of these robots.
Expected<std::vector<RuleCount>, Failure> CountRules(
    RunStore& store, const std::vector<int>& ids);

/// Adds counts of like rules.
void AddRules(const std::vector<RuleCount>& more, std::vector<RuleCount>& all);

}  // namespace plsc
