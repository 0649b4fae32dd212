#pragma once

// A study like the paper's in little, its lives evaluated by a look: plastic
// and baseline in two seasons, and static references; three runs each, of which
// plastic/3 was stopped and tilted/3 was never begun.

#include <string>

#include "runtime/report/report.h"
#include "runtime/study/study_folder.h"
#include "tests/runtime/store/stored_run.h"
#include "tests/runtime/study/small_study.h"

namespace plsc::test {

struct ReportedStudy {
  Scratch scratch;
  std::string folder = scratch / "reported";
  StudyReport report;

  ReportedStudy();
  /// Made once a program.
  static const ReportedStudy& Get();
};

}  // namespace plsc::test
