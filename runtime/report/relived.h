#pragma once

// What lives that were lived again say of the recorded ones, a generation at a
// time. A record is one draw from what a robot does, and selection keeps lucky
// draws; the median of its lives is what it does. Pure functions of the lives.

#include <optional>
#include <string>
#include <vector>

#include "runtime/relive/orders.h"
#include "runtime/relive/relived_life.h"
#include "runtime/report/quantiles.h"

namespace plsc {

/// A robot's lives in a season by one measure. In SI.
struct RelivedValue {
  int lives = 0;        ///< that have a value; the others were not completed
  Quartiles quartiles;  ///< no numbers without lives
};

/// A measure in a season. What is no number is not known.
struct RelivedMeasure {
  double mean = 0;    ///< over survivors, of the medians of their lives
  Quartiles medians;  ///< over survivors
  RelivedValue best;
  RelivedValue best_by_other;  ///< by the other engine
  /// Over the survivors that differ between seasons, in the season's ground:
  /// means of their medians as they are and with other seasons' bodies and
  /// brains, and quartiles over robots of what they lose.
  int swapped = 0;  ///< robots
  double own = 0;
  double other = 0;
  Quartiles losses;
};

struct RelivedRobotValues {
  int id = 0;
  std::vector<RelivedValue> values;  ///< a measure's seasons side by side
};

struct RelivedGeneration {
  int generation = 0;
  int best = 0;  ///< id
  int survivors = 0;
  /// Of each robot, so many that all have lived; those beyond do not count.
  int lives = 0;
  int swaps = 0;        ///< likewise, of each plastic robot in each season
  int other_lives = 0;  ///< of the best, by the other engine
  std::size_t seasons = 0;
  /// Of RelivedMeasures(), a measure's seasons side by side.
  std::vector<RelivedMeasure> measures;
  std::vector<RelivedRobotValues> robots;  ///< survivors, as selected

  const RelivedMeasure& of(std::size_t measure, std::size_t season) const {
    return measures[measure * seasons + season];
  }
};

/// By LifeOf, each in the order of n.
class RelivedLives {
 public:
  explicit RelivedLives(std::vector<RelivedSeason> lives);

  /// What a robot lived so; `most` of them at most.
  RelivedValue ValueOf(const LifeOf& of, std::size_t measure, int most) const;
  /// From 1 on without a gap.
  int CountOf(const LifeOf& of) const;
  /// Seasons whose phenotypes the robot was given in this one.
  std::vector<int> SwapsOf(int id, int season) const;

 private:
  struct Group {
    LifeOf of;
    std::vector<int> n;
    std::vector<std::vector<std::optional<double>>> measures;  // by life
  };
  const Group* Find(const LifeOf& of) const;
  std::vector<Group> groups_;  // sorted
};

RelivedGeneration SummariseRelived(const RelivedMembers& members,
                                   std::size_t seasons,
                                   const RelivedLives& lives);

}  // namespace plsc
