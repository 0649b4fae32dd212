#pragma once

// What tests of studies share: a study of small runs, and their execution with
// robots that are evaluated by a look (tests/runtime/evolve/fake_run.h) but
// stored for real.

#include "runtime/study/run_study.h"
#include "runtime/study/study.h"

namespace plsc::test {

/// Experiments plastic and baseline, 2 repetitions each, of SmallExperiment.
Study SmallStudy();

/// Executes the run, or goes on with it. `most`: evaluations after which it is
/// stopped; 0: none.
RunEnd Execute(const RunTask& task, int most = 0);

}  // namespace plsc::test
