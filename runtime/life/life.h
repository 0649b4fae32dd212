#pragma once

// One genotype through all seasons of a scenario: in each it senses, develops
// and lives. With everything that is known of a season; its results alone are
// runtime/life/evaluation.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "runtime/life/disturbances.h"
#include "runtime/life/season_result.h"
#include "runtime/life/simulated.h"
#include "runtime/scenario/scenario.h"
#include "sim/simulate.h"
#include "sim/trajectory.h"
#include "sim/watcher.h"

namespace plsc {

/// One season with its whole trajectory.
struct SeasonLife {
  SeasonResult result;
  Trajectory trajectory;
  std::optional<Phenotype> robot;  ///< that lived, or was not simulated
};

class SeasonDeveloper;

/// A genotype on its way through a scenario, season by season: sense, regulate,
/// develop, live. What it senses must be known (CheckSenses).
class Life {
 public:
  /// The watcher, if any, must outlive it. `inherited`: see SeasonDeveloper.
  Life(const Genotype& genotype, const Scenario& scenario,
       Watcher* watcher = nullptr, Senses inherited = {},
       Disturbances disturbances = {});
  ~Life();
  Life(const Life&) = delete;
  Life& operator=(const Life&) = delete;

  bool is_over() const;
  /// Lives the next season.
  SeasonLife Next();

 private:
  bool LivesOn() const;
  Lived LiveIn(const Season& season, const SimulationOptions& options,
               const Phenotype& robot, const Spot& spot) const;

  const Genotype genotype_;
  const Scenario scenario_;
  const Senses inherited_;
  const Disturbances disturbances_;
  Watcher* watcher_ = nullptr;
  std::unique_ptr<SeasonDeveloper> seasons_;
  std::size_t next_ = 0;
  std::string ended_;  ///< continuous lives: why there is no robot any more
  std::optional<Phenotype> robot_;  ///< of the season before
  LifeState state_;                 ///< at its end
};

/// A simulated season of a robot of `size`, measured; its begin and inclination
/// are not known from the trajectory.
Simulated MeasureSeason(const Trajectory& trajectory, const Scenario& scenario,
                        int size);

}  // namespace plsc
