#include "runtime/study/run_study.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <string>
#include <vector>

#include "runtime/store/result_dump.h"
#include "runtime/study/slice.h"
#include "runtime/study/study_folder.h"
#include "tests/runtime/store/stored_run.h"
#include "tests/runtime/study/small_study.h"

namespace plsc {

namespace {

using test::Scratch;
using test::SmallStudy;

using Names = std::vector<std::string>;

std::string StepName(StudyStep step) {
  const Names names = {"begins",      "resumes", "finished",
                       "done before", "in use",  "damaged"};
  return names[static_cast<std::size_t>(step)];
}

/// A study in a folder, what happens in it, and when it is stopped.
struct Fixture {
  Scratch scratch;
  std::string folder = scratch / "study";
  Study study = SmallStudy();
  Names steps;
  int most = 0;  ///< evaluations of a run; 0: all
  StudyOptions options;

  Fixture() {
    REQUIRE(PrepareFolder(folder, study) == std::nullopt);
    options.execute = [this](const RunTask& task) {
      return test::Execute(task, most);
    };
    options.on_step = [this](const StudyRun& run, StudyStep step,
                             const RunReport&) {
      steps.push_back(RunName(study, run) + " " + StepName(step));
    };
  }
  StudyResult Run(const std::string& only = "", const Shard& shard = {}) {
    steps.clear();
    return RunStudy(folder, study, RunsIn(study, only, shard), options);
  }
  std::string Dump(const StudyRun& run) {
    const Expected<std::string, Failure> dump =
        DumpResults(RunPath(folder, study, run));
    REQUIRE(dump);
    return *dump;
  }
};

}  // namespace

TEST_CASE("A study's runs are done once", "[run_study]") {
  Fixture fixture;
  StudyResult result = fixture.Run();
  CHECK(result.end == RunEnd::kFinished);
  CHECK(result.finished == 4);
  CHECK_FALSE(result.stopped_in);
  CHECK(fixture.steps == Names{"plastic/1 begins", "plastic/1 finished",
                               "plastic/2 begins", "plastic/2 finished",
                               "baseline/1 begins", "baseline/1 finished",
                               "baseline/2 begins", "baseline/2 finished"});
  std::set<std::string> dumps;
  for (const StudyRun& run : RunsOf(fixture.study)) {
    CHECK(ReportOn(fixture.folder, fixture.study, run).state ==
          RunState::kDone);
    dumps.insert(fixture.Dump(run));
  }
  CHECK(dumps.size() == 4);

  result = fixture.Run();
  CHECK(result.end == RunEnd::kFinished);
  CHECK(result.finished == 0);
  CHECK(result.done_before == 4);
  CHECK(fixture.steps == Names{"plastic/1 done before", "plastic/2 done before",
                               "baseline/1 done before",
                               "baseline/2 done before"});
}

TEST_CASE("A study that is stopped again and again ends as one that is not",
          "[run_study]") {
  Fixture whole;
  whole.Run();
  Fixture parts;
  int stops = 0;
  StudyResult result;
  for (parts.most = 5;; parts.most += 5) {
    result = parts.Run();
    if (result.end == RunEnd::kFinished) break;
    REQUIRE(result.end == RunEnd::kStopped);
    REQUIRE(result.stopped_in);
    ++stops;
    if (parts.most > 30) parts.most = 5;
    REQUIRE(stops < 100);
  }
  CHECK(stops > 4);
  CHECK(result.finished + result.done_before == 4);
  for (const StudyRun& run : RunsOf(whole.study)) {
    CAPTURE(RunName(whole.study, run));
    CHECK(parts.Dump(run) == whole.Dump(run));
  }
}

TEST_CASE("Shards and names leave the rest of a study alone", "[run_study]") {
  Fixture fixture;
  CHECK(fixture.Run("", {2, 3}).finished == 1);
  CHECK(fixture.steps == Names{"plastic/2 begins", "plastic/2 finished"});
  CHECK(fixture.Run("baseline/2").finished == 1);
  CHECK(ReportOn(fixture.folder, fixture.study, {0, 1}).state ==
        RunState::kMissing);
  const StudyResult result = fixture.Run();
  CHECK(result.finished == 2);
  CHECK(result.done_before == 2);
}

TEST_CASE("A damaged run is left, and keeps no other from being done",
          "[run_study]") {
  Fixture fixture;
  const std::string path = RunPath(fixture.folder, fixture.study, {0, 2});
  test::WriteBytes(path, "not a store");
  const StudyResult result = fixture.Run();
  CHECK(result.end == RunEnd::kFailed);
  CHECK(result.damaged == 1);
  CHECK(result.finished == 3);
  CHECK_FALSE(result.stopped_in);
  CHECK(std::count(fixture.steps.begin(), fixture.steps.end(),
                   "plastic/2 damaged") == 1);
  CHECK(test::ReadBytes(path) == "not a store");
}

TEST_CASE("A run that fails ends the study there", "[run_study]") {
  Fixture fixture;
  int executed = 0;
  fixture.options.execute = [&](const RunTask& task) {
    return ++executed == 2 ? RunEnd::kFailed : test::Execute(task);
  };
  const StudyResult result = fixture.Run();
  CHECK(result.end == RunEnd::kFailed);
  CHECK(result.finished == 1);
  REQUIRE(result.stopped_in);
  CHECK(*result.stopped_in == StudyRun{0, 2});
  CHECK(executed == 2);
}

TEST_CASE("A run that another process took meanwhile is left", "[run_study]") {
  Fixture fixture;
  fixture.options.execute = [&](const RunTask& task) {
    return task.run == StudyRun{0, 1} ? RunEnd::kInUse : test::Execute(task);
  };
  const StudyResult result = fixture.Run();
  CHECK(result.end == RunEnd::kFinished);
  CHECK(result.finished == 3);
  CHECK(result.in_use == 1);
  CHECK(fixture.steps[1] == "plastic/1 in use");
}

TEST_CASE("A run that another process did meanwhile is left", "[run_study]") {
  Fixture fixture;
  int executed = 0;
  fixture.options.execute = [&](const RunTask& task) {
    // As if the other had done it between our look and our try.
    const RunEnd end = test::Execute(task);
    return ++executed == 2 ? RunEnd::kFailed : end;
  };
  const StudyResult result = fixture.Run();
  CHECK(result.end == RunEnd::kFinished);
  CHECK(result.finished == 3);
  CHECK(result.done_before == 1);
}

}  // namespace plsc
