#pragma once

// Does a study's runs one after the other: begins what is missing, goes on
// with what is unfinished, leaves what is done and what others work on. How a
// run is executed is the caller's business, and so is what is printed.

#include <functional>
#include <string>
#include <vector>

#include "runtime/study/run_report.h"
#include "runtime/study/study.h"

namespace plsc {

enum class RunEnd : std::uint8_t {
  kFinished,
  kStopped,
  kInUse,  ///< by another process, which began since we looked
  kFailed,
};

struct RunTask {
  StudyRun run;
  std::string path;  ///< of its store
  Experiment experiment;
  bool resume = false;  ///< the store was there when we looked
};

/// What happened to a run, for whoever prints.
enum class StudyStep : std::uint8_t {
  kBegins,
  kResumes,
  kFinished,
  kDoneBefore,
  kInUse,    ///< another process works on it: left
  kDamaged,  ///< left
};

struct StudyOptions {
  /// A failure was told to the user already.
  std::function<RunEnd(const RunTask& task)> execute;
  /// `report` as it was before the step.
  std::function<void(const StudyRun& run, StudyStep step,
                     const RunReport& report)>
      on_step;
};

struct StudyResult {
  RunEnd end = RunEnd::kFinished;  ///< kFailed also if a run is damaged
  int finished = 0;                ///< by this call
  int done_before = 0;
  int in_use = 0;
  int damaged = 0;
  /// Where it ended; nothing if all runs were visited.
  std::optional<StudyRun> stopped_in;
};

/// `folder` as PrepareFolder leaves it. Ends with the first run that is stopped
/// or fails: what kept it from going on, as a full disk, keeps the others too.
StudyResult RunStudy(const std::string& folder, const Study& study,
                     const std::vector<StudyRun>& runs,
                     const StudyOptions& options);

}  // namespace plsc
