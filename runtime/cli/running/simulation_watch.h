#pragma once

// What the simulate command does while a robot lives: shows how far it is on a
// terminal, listens for Ctrl-C, and records if asked to.

#include <chrono>
#include <iosfwd>
#include <optional>
#include <string>

#include "runtime/scenario/scenario.h"
#include "sim/pose_recorder.h"

namespace plsc::cli {

/// How far a scenario is. Times of life in s of simulated time.
struct SimulationProgress {
  std::string season;
  std::size_t number = 1;  ///< of the season, from 1
  std::size_t seasons = 1;
  double lived = 0;     ///< of this season
  double duration = 0;  ///< of this season
  double lived_before = 0;
  double all = 0;      ///< of all seasons
  double seconds = 0;  ///< on the clock
};

/// "season tilted (2 of 2)  34.2/50.0 s  212 x real time  0:03 left". The time
/// left takes coming seasons to be as fast as those so far.
std::string ProgressText(const SimulationProgress& progress);

class SimulationWatch : public Watcher {
 public:
  /// Shows progress if `terminal` is given. Must not outlive the scenario.
  SimulationWatch(const Scenario& scenario, std::ostream* terminal,
                  bool is_recording);

  void Begin(const Phenotype& robot, const SimulationOptions& options,
             double begin) override;
  /// False after Ctrl-C.
  bool See(const World& world, std::int64_t step) override;

  /// Call when a season is over, before anything is printed: wipes the line.
  /// Gives the season's motion, without samples when nothing was recorded.
  Motion FinishSeason();

 private:
  void Report(std::int64_t step);

  const Scenario& scenario_;
  std::ostream* terminal_;
  bool is_recording_;
  PoseRecorder recorder_;
  SimulationProgress progress_;
  double step_ = 0;        ///< s
  double shown_at_ = 0;    ///< s on the clock
  std::size_t width_ = 0;  ///< characters on the line
  std::chrono::steady_clock::time_point start_;
};

}  // namespace plsc::cli
