#pragma once

// How fast a run goes, from what it tells of itself and a clock: for people
// (progress.h) and for programs (json_log.h) the same numbers.

#include <cstdint>
#include <deque>
#include <optional>

#include "runtime/evolve/evolve.h"

namespace plsc::cli {

/// Nothing where too little is known yet.
struct Pace {
  std::optional<double> evaluations_per_second;
  /// s of robots' lives simulated a second; what was looked up is not in it.
  std::optional<double> times_real;
  /// Of all seasons of robots since the session began, 0 to 1.
  std::optional<double> looked_up_share;
  std::optional<double> seconds_left;
};

/// One session: from the start of this process, so a run that goes on does not
/// count what was done before. Rates are those of lately, because robots grow
/// and caches fill: over the last minute, or since the generation before the
/// present one began, whichever is longer. Parts of a generation would mislead:
/// what can be looked up comes first.
class PaceMeter {
 public:
  /// `evaluations_before`: of the run, when the session began.
  explicit PaceMeter(std::int64_t evaluations_before = 0);

  /// `seconds` since the session began, never less than the last.
  void Add(double seconds, const Progress& progress);
  /// At a moment not before the last Add, which may be a while ago.
  Pace At(double seconds) const;

 private:
  struct Sample {
    double seconds = 0;
    int generation = 0;
    std::int64_t evaluations = 0;
    double simulated_seconds = 0;
  };
  double WindowBegin(double seconds) const;

  Progress last_;
  std::deque<Sample> samples_;   // of the window, oldest first
  double previous_begin_ = 0;    // of the generation before last_'s
  double generation_begin_ = 0;  // of last_'s
};

}  // namespace plsc::cli
