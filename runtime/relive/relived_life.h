#pragma once

// A season that a robot of a run lived again, and what it was lived for: as it
// was, by the engine that the run did not have, or with the body and brain of
// another season (swapped).

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/life/season_result.h"

namespace plsc {

/// Whose life in which season, and how. A robot has several of each kind.
struct LifeOf {
  int id = 0;
  bool is_other_engine = false;
  int season = 0;     ///< whose ground; an index, as in the scenario
  int phenotype = 0;  ///< the season whose body and brain it has

  bool is_swapped() const { return season != phenotype; }
  friend auto operator<=>(const LifeOf&, const LifeOf&) = default;
};

struct RelivedSeason {
  LifeOf of;
  int n = 0;        ///< which of these lives, from 1
  double lift = 0;  ///< m, that the start was higher
  Outcome outcome = Outcome::kCompleted;
  std::string reason;
  Behaviour behaviour;
  std::optional<double> fitness;  ///< m/s
  std::uint64_t state_hash = 0;
  std::int64_t steps = 0;
  int solver_warnings = 0;
};

RelivedSeason RelivedOf(const LifeOf& of, int n, double lift,
                        const SeasonResult& result);

/// What can differ between lives of one robot: columns of a store, fitness
/// first.
const std::vector<std::string>& RelivedMeasures();

/// By RelivedMeasures; nothing where the life has none.
std::vector<std::optional<double>> MeasuresOf(const Behaviour& behaviour,
                                              std::optional<double> fitness);

}  // namespace plsc
