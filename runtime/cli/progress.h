#pragma once

// The line that shows how far a run is: rate, time left, best so far. On a
// terminal one line that is drawn again and again; elsewhere (a log file) a
// line a generation.

#include <chrono>
#include <iosfwd>
#include <string>

#include "runtime/evolve/evolve.h"

namespace plsc::cli {

/// "generation 3/10  evaluations 74/200  12.3/s  2 of 2 workers busy  best
/// flat 1.23 tilted 0.90 cm/s  0:32 left". `generations` as in Experiment.
std::string ProgressText(const Progress& progress, int generations,
                         double seconds);

/// "0:07", "12:40", "3:05:00".
std::string DurationText(double seconds);

class ProgressLine {
 public:
  ProgressLine(std::ostream& out, bool is_terminal, int generations);

  void Show(const Progress& progress);
  /// Leaves the last line as it is and goes to the next.
  void Finish();
  double seconds() const;  ///< since construction

 private:
  std::ostream& out_;
  bool is_terminal_;
  int generations_;
  int shown_generation_ = -1;
  std::size_t shown_width_ = 0;
  double shown_at_ = -1;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace plsc::cli
