#pragma once

// How far a run is, for programs: `--json-log FILE`, one JSON object a line,
// each written out at once. Keys and events are fixed and described in
// docs/experiments.md, "Progress"; a key that has no value is null.

#include <cstdint>
#include <fstream>
#include <functional>
#include <ostream>
#include <string>

#include "grammar/failure.h"
#include "runtime/cli/running/pace.h"
#include "runtime/evolve/evolve.h"

namespace plsc::cli {

/// What the first line says of the run.
struct JsonLogStart {
  std::string run;         ///< the store
  std::string experiment;  ///< its name
  std::uint64_t seed = 0;
  int generations = 0;
  std::int64_t evaluations = 0;  ///< done in earlier sessions
  std::int64_t total = 0;        ///< of the whole run
};

class JsonLog {
 public:
  /// `standard_output` for the path "-".
  explicit JsonLog(std::ostream& standard_output);

  /// Lines are appended to a log that exists, so a run that goes on continues
  /// it; to another file nothing is. What went wrong, as "cannot write to 'x':
  /// Permission denied".
  MaybeFailure Open(const std::string& path);

  /// As if it had not been opened: a file that Open made is deleted.
  void Discard();

  void Start(const JsonLogStart& start);
  /// Writes a line when a generation begins, and every 10 s.
  void Report(const Progress& progress);
  /// Time goes on though nothing has happened since Report; cheap.
  void Tick();
  void Finish(Ending ending, const std::string& failure);

  /// The first line that could not be written (a full disk); no more are.
  const MaybeFailure& failure() const { return failure_; }

  /// For tests.
  void SetClock(std::function<double()> clock) { clock_ = std::move(clock); }

 private:
  void WriteProgress(const char* event, double now);
  void Write(const std::string& line);

  std::ostream& standard_output_;
  std::ofstream file_;
  std::ostream* out_ = nullptr;  // nullptr: not open
  std::string path_;
  bool is_new_ = false;  // made by Open
  MaybeFailure failure_;
  std::function<double()> clock_;  // s since the log was made
  PaceMeter meter_;
  Progress last_;
  bool has_progress_ = false;
  double written_at_ = 0;
};

}  // namespace plsc::cli
