#pragma once

// The line that shows how far a run is, for people: on a terminal one line that
// is drawn again and again and fits its width; elsewhere (a log file) a line a
// generation and at least one a minute.

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>

#include "runtime/cli/running/pace.h"
#include "runtime/evolve/evolve.h"

namespace plsc::cli {

/// "generation 3/10  74/200 evaluations  12.3/s  0:32 left  25x real time  13 %
/// looked up  2/2 busy  flat best 1.23  median 0.41  tilted ...  cm/s".
/// `generations` as in Experiment. If that has more than `width` columns the
/// words are shortened, and then what matters least is left out; 0: any width.
std::string ProgressText(const Progress& progress, int generations,
                         const Pace& pace, int width);

/// "0:07", "12:40", "3:05:00".
std::string DurationText(double seconds);

/// Columns of the terminal that standard error is, at this moment; else what
/// the variable COLUMNS says, else 80.
int TerminalWidth();

/// A function that tells the seconds since it was made.
std::function<double()> Stopwatch();

class ProgressLine {
 public:
  /// `evaluations_before`: of the run, when this session began to work on it.
  ProgressLine(std::ostream& out, bool is_terminal, int generations,
               std::int64_t evaluations_before = 0);

  void Report(const Progress& progress);
  /// Time goes on though nothing has happened since Report; cheap.
  void Tick();
  /// Shows the latest again and goes to the next line.
  void Finish();
  double seconds() const { return clock_(); }  ///< since construction

  /// For tests.
  void SetWorld(std::function<double()> clock, std::function<int()> width);

 private:
  bool IsDue(double now, bool is_new_generation) const;
  void Draw(double now);

  std::ostream& out_;
  bool is_terminal_;
  int generations_;
  std::function<double()> clock_;
  std::function<int()> width_;
  PaceMeter meter_;
  Progress last_;
  bool has_progress_ = false;
  bool is_drawn_ = false;  // last_
  int drawn_generation_ = -1;
  double drawn_at_ = -1;
  std::size_t drawn_width_ = 0;
};

}  // namespace plsc::cli
