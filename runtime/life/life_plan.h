#pragma once

// How to evaluate genotypes without simulating anything twice: what is to be
// simulated is known, and has a key, before it is; what is known already can
// be put in its place. Planning and assembling are a millionth of the work of
// simulating.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "runtime/life/disturbances.h"
#include "runtime/life/season_result.h"
#include "runtime/life/simulated.h"
#include "runtime/text/key.h"

namespace plsc {

/// Consecutive seasons that are simulated in one go: one of an independent
/// life, all of a continuous one. Where no robot develops in an independent
/// life there is nothing to simulate.
struct LifePiece {
  std::size_t first = 0;  ///< index into the scenario's seasons
  /// One a season: of all that its simulation is a function of, but the
  /// program and the machine.
  std::vector<Key> keys;
};

struct Trial;

/// What stands behind one season of an evaluation.
struct SeasonEvidence {
  /// Of `body` and `brain`. All three are empty (zero) if no robot developed.
  Key phenotype;
  std::string body;   ///< JSON, the shape of `plsc develop --format json`
  std::string brain;  ///< likewise
  /// LifePiece::keys; zero if there was nothing to simulate.
  Key simulation;
  Simulated simulated;
  /// Where a season is lived several times, or disturbed: all of these lives,
  /// of which the above is the first. LifePlanner knows one at a time.
  std::vector<Trial> trials;
};

/// A season lived once of several times.
struct Trial {
  Disturbance disturbance;
  SeasonResult result;
  SeasonEvidence evidence;
};

struct EvaluatedLife {
  Evaluation evaluation;
  std::vector<SeasonEvidence> evidence;  ///< an item a season
};

/// Simulates a robot in a season from a fresh start.
using SeasonSimulator =
    std::function<Simulated(const Phenotype& robot, const Season& season,
                            const Disturbance& disturbance)>;

/// Knows one scenario, whose senses answer all genotypes it is given. A life is
/// planned, simulated and assembled with the same disturbances.
class LifePlanner {
 public:
  /// Puts cores down where robots feel the ground, to know what they feel.
  /// `simulate` stands in for the physics in tests, of independent lives.
  explicit LifePlanner(Scenario scenario, SeasonSimulator simulate = {});

  const Scenario& scenario() const { return scenario_; }

  std::vector<LifePiece> Plan(const Genotype& genotype, const Senses& inherited,
                              const Disturbances& disturbances = {}) const;
  /// One piece, an item a season. What takes the time.
  std::vector<Simulated> Simulate(const Genotype& genotype,
                                  const Senses& inherited,
                                  const LifePiece& piece,
                                  const Disturbances& disturbances = {}) const;
  /// `simulated`: an item a season, nothing where nothing was to simulate.
  EvaluatedLife Assemble(const Genotype& genotype, const Senses& inherited,
                         const std::vector<std::optional<Simulated>>& simulated,
                         const Disturbances& disturbances = {}) const;

 private:
  std::vector<LifePiece> PlanSeasons(const Genotype& genotype,
                                     const Senses& inherited,
                                     const Disturbances& disturbances) const;
  std::vector<LifePiece> PlanWhole(const Genotype& genotype,
                                   const Senses& inherited,
                                   const Disturbances& disturbances) const;
  /// Whether it is known what develops in the season.
  bool IsDeveloped(const Simulated& simulated) const;
  Key KeyOfSeason(std::size_t season, bool asks_imu, const Key& robot,
                  const Disturbance& disturbance) const;
  /// What a robot feels in a season of an independent life; nothing if nobody
  /// does.
  std::optional<double> FeltIn(std::size_t season,
                               const Disturbances& disturbances) const;

  Scenario scenario_;
  SeasonSimulator simulate_;
  std::vector<std::string> season_texts_;  // all of a season but its name
  /// What robots feel in each season at the origin; nothing if they never do.
  std::vector<std::optional<double>> inclinations_;
};

}  // namespace plsc
