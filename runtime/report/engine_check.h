#pragma once

// The same robots by two engines: whether the one would rank them as the other
// did, season by season, and how far their Speeds are apart. What is written of
// it, as text and JSON, is here, too.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "runtime/life/season_result.h"
#include "runtime/scenario/scenario.h"

namespace plsc {

/// Spearman's: of the ranks, equal values having the mean of theirs; nothing
/// where all values of a side are equal, or there are fewer than two.
std::optional<double> RankCorrelation(const std::vector<double>& x,
                                      const std::vector<double>& y);

/// Speed of a robot in a season, m/s; nothing where its life was not completed.
struct CheckedLife {
  int id = 0;
  std::optional<double> stored;
  std::optional<double> now;
};

struct SeasonCheck {
  std::string season;
  EngineKind stored_engine = EngineKind::kOde;
  std::vector<CheckedLife> lives;  ///< in the order of the robots
  int both = 0;                    ///< completed by both engines
  int only_stored = 0;
  int only_now = 0;
  /// Of those by both:
  std::optional<double> rank_correlation;
  std::optional<double> median_difference;  ///< m/s, without its sign
  std::optional<double> largest_difference;
};

struct EngineCheck {
  EngineKind engine = EngineKind::kOde;  ///< that they live by now
  int generation = -1;  ///< whose survivors they are; -1: others
  int robots = 0;
  std::vector<SeasonCheck> seasons;
};

/// A robot as it is stored and as it lived now.
struct LivedTwice {
  int id = 0;
  Evaluation stored;
  Evaluation now;
};

/// `stored`: the scenario that they lived then.
std::vector<SeasonCheck> CheckSeasons(const Scenario& stored,
                                      const std::vector<LivedTwice>& robots);

/// A line a season, behind a line that says of whom.
std::string EngineCheckText(const EngineCheck& check);

/// Speeds in m/s.
nlohmann::ordered_json EngineCheckJson(const EngineCheck& check);

}  // namespace plsc
