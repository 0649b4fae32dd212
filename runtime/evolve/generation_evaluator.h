#pragma once

// One generation evaluated: every piece of every life is looked up, or
// simulated by a worker, once, however many robots live it. Lives are planned
// while the workers work, not much before it is their turn: what waits for a
// worker takes memory, and who asks for a stop does not wait for plans.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grammar/failure.h"
#include "runtime/evolve/individual.h"
#include "runtime/evolve/simulation_cache.h"
#include "runtime/evolve/trials.h"
#include "runtime/life/life_plan.h"
#include "runtime/life/simulated.h"
#include "runtime/workers/workers.h"

namespace plsc {

/// Counted in seasons of robots.
struct EvaluationCounts {
  std::int64_t simulations = 0;
  /// Found in a cache, or the same as another's of the generation.
  std::int64_t looked_up = 0;
  double simulated_seconds = 0;  ///< of the simulations
};

struct EvaluatedRobot {
  std::size_t robot = 0;  ///< index into what Begin was given
  EvaluatedLife life;
};

/// What it is given must outlive it. One generation after the other.
class GenerationEvaluator {
 public:
  /// Of own lives (`plan`) caches are neither asked nor told.
  GenerationEvaluator(const LifePlanner& planner, Workers& workers,
                      std::vector<SimulationCache*> caches,
                      const TrialPlan& plan = {})
      : planner_(planner),
        workers_(workers),
        caches_(std::move(caches)),
        plan_(plan) {
    if (plan_.options.own_lives) caches_.clear();
  }

  /// Robots, which stay where they are until the last is evaluated. Those with
  /// an evaluation are so already.
  void Begin(const std::vector<Individual>& robots);
  /// In the order in which they become known; waits at most `timeout_ms`, and
  /// not at all if there are some.
  std::vector<EvaluatedRobot> Wait(int timeout_ms);
  /// Nothing more is planned or begun; Wait returns what was begun.
  void Cancel();
  /// Robots still to be evaluated.
  std::size_t outstanding() const { return outstanding_; }
  /// What went wrong, if no more will be evaluated.
  const MaybeFailure& failure() const { return failure_; }
  const EvaluationCounts& counts() const { return counts_; }

 private:
  struct OpenRobot {
    std::vector<Disturbances> trials;
    // By trial and season.
    std::vector<std::vector<std::optional<Simulated>>> lives;
    std::size_t pieces = 0;  // not known yet, of all trials
  };
  // A simulation is a function of its keys alone, so whoever lives the same may
  // live it in other seasons than whom it was ordered for: another robot, or
  // the same one again.
  struct Place {
    std::size_t robot = 0;
    std::size_t trial = 0;
    std::size_t first = 0;  // season
  };
  struct Order {
    LifePiece piece;                   // of whom it is simulated for
    std::vector<Place> places;         // where it is lived and not known yet
    std::vector<Simulated> simulated;  // an item a season once it is done
  };

  bool HasRoom() const;
  bool PlanSome();
  void Plan(std::size_t robot);
  void Take(const Place& place, LifePiece piece);
  bool TakeKnown(const Place& place, const LifePiece& piece);
  std::optional<std::vector<Simulated>> LookUp(const LifePiece& piece);
  void Fill(const Place& place, const std::vector<Simulated>& simulated);
  void Receive(const Reply& reply);
  EvaluatedLife Assemble(std::size_t robot);
  double StepOf(std::size_t season) const;

  const LifePlanner& planner_;
  Workers& workers_;
  std::vector<SimulationCache*> caches_;
  TrialPlan plan_;
  const std::vector<Individual>* robots_ = nullptr;
  std::size_t next_ = 0;  // robot to be planned
  std::vector<OpenRobot> open_;
  std::vector<Order> orders_;                        // by ticket
  std::map<std::vector<Key>, std::size_t> tickets_;  // by the piece's keys
  std::deque<std::size_t> known_;                    // robots with all seasons
  std::size_t outstanding_ = 0;
  MaybeFailure failure_;
  EvaluationCounts counts_;
};

}  // namespace plsc
