// Runs one by one, each decided by what its store says at this moment: begun if
// it is missing, gone on with if it is unfinished, left if it is done or
// another process works on it. Nobody hands out runs. Any number of processes
// on any number of hosts go through the same list, the lock of a store is what
// keeps two off one run, and whoever loses the race for it goes on with the
// next; so a study needs no coordinator and survives any of its processes.

#include "runtime/study/run_study.h"

#include "runtime/study/study_folder.h"

namespace plsc {

namespace {

class Visitor {
 public:
  Visitor(const std::string& folder, const Study& study,
          const StudyOptions& options)
      : folder_(folder), study_(study), options_(options) {}

  /// Whether to go on with the next run.
  bool Visit(const StudyRun& run) {
    const RunReport report = ReportOn(folder_, study_, run);
    switch (report.state) {
      case RunState::kMissing:
      case RunState::kUnfinished:
        return Execute(run, report);
      default:
        Leave(run, report);
        return true;
    }
  }

  StudyResult result;

 private:
  void Leave(const StudyRun& run, const RunReport& report) {
    if (report.state == RunState::kDone) {
      ++result.done_before;
      options_.on_step(run, StudyStep::kDoneBefore, report);
    } else if (report.state == RunState::kRunning) {
      ++result.in_use;
      options_.on_step(run, StudyStep::kInUse, report);
    } else {
      ++result.damaged;
      result.end = RunEnd::kFailed;
      options_.on_step(run, StudyStep::kDamaged, report);
    }
  }

  bool Execute(const StudyRun& run, const RunReport& report) {
    const bool resume = report.state == RunState::kUnfinished;
    options_.on_step(run, resume ? StudyStep::kResumes : StudyStep::kBegins,
                     report);
    const RunEnd end = options_.execute({run, RunPath(folder_, study_, run),
                                         ExperimentOf(study_, run), resume});
    if (end == RunEnd::kFinished) {
      ++result.finished;
      options_.on_step(run, StudyStep::kFinished,
                       ReportOn(folder_, study_, run));
      return true;
    }
    const RunReport now = ReportOn(folder_, study_, run);
    if (end == RunEnd::kInUse) {
      ++result.in_use;
      options_.on_step(run, StudyStep::kInUse, now);
      return true;
    }
    // Another process may even have done it since we looked.
    if (end == RunEnd::kFailed && now.state == RunState::kDone) {
      Leave(run, now);
      return true;
    }
    result.end = end;
    result.stopped_in = run;
    return false;
  }

  const std::string& folder_;
  const Study& study_;
  const StudyOptions& options_;
};

}  // namespace

StudyResult RunStudy(const std::string& folder, const Study& study,
                     const std::vector<StudyRun>& runs,
                     const StudyOptions& options) {
  Visitor visitor(folder, study, options);
  for (const StudyRun& run : runs)
    if (!visitor.Visit(run)) break;
  return visitor.result;
}

}  // namespace plsc
