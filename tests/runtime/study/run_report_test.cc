#include "runtime/study/run_report.h"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <string>

#include "runtime/store/lock.h"
#include "runtime/store/run_store.h"
#include "runtime/study/study_folder.h"
#include "tests/runtime/store/stored_run.h"
#include "tests/runtime/study/small_study.h"

namespace plsc {

namespace {

using test::Scratch;
using test::SmallStudy;

/// In a folder of its own, plastic/1 done up to `most` evaluations.
struct Prepared {
  Scratch scratch;
  std::string folder = scratch / "study";
  Study study = SmallStudy();
  StudyRun run = {0, 1};
  std::string path = RunPath(folder, study, run);

  explicit Prepared(int most) {
    REQUIRE(PrepareFolder(folder, study) == std::nullopt);
    end = test::Execute({run, path, ExperimentOf(study, run), false}, most);
  }
  RunEnd end;
};

}  // namespace

TEST_CASE("States of a run have names", "[run_report]") {
  CHECK(NameIn(kRunStateNames, RunState::kMissing) == "missing");
  CHECK(NameIn(kRunStateNames, RunState::kUnfinished) == "unfinished");
  CHECK(NameIn(kRunStateNames, RunState::kRunning) == "running");
  CHECK(NameIn(kRunStateNames, RunState::kDone) == "done");
  CHECK(NameIn(kRunStateNames, RunState::kDamaged) == "damaged");
}

TEST_CASE("A run that is done shows the best robot's speeds", "[run_report]") {
  const Prepared prepared(0);
  REQUIRE(prepared.end == RunEnd::kFinished);
  const RunReport report =
      ReportOn(prepared.folder, prepared.study, prepared.run);
  CHECK(report.state == RunState::kDone);
  CHECK(report.problem.empty());
  CHECK(report.generations == 5);
  CHECK(report.evaluations == 8 + 4 * 6);
  RunStore store;
  REQUIRE(store.OpenForReading(prepared.path) == std::nullopt);
  const Individual best = *store.Find(store.Status()->best);
  REQUIRE(report.best.size() == best.evaluation.seasons.size());
  for (std::size_t i = 0; i < report.best.size(); ++i) {
    CHECK(report.best[i].season == best.evaluation.seasons[i].season);
    CHECK(report.best[i].speed.value_or(-9) ==
          best.evaluation.seasons[i].behaviour.displacement_velocity_hill);
  }
  CHECK(ReportOn(prepared.folder, prepared.study, {1, 1}).state ==
        RunState::kMissing);
}

TEST_CASE("A run that was stopped is unfinished until it goes on",
          "[run_report]") {
  const Prepared prepared(16);
  REQUIRE(prepared.end == RunEnd::kStopped);
  RunReport report = ReportOn(prepared.folder, prepared.study, prepared.run);
  CHECK(report.state == RunState::kUnfinished);
  CHECK(report.generations >= 2);
  CHECK(report.generations < 5);
  CHECK(report.evaluations >= 16);
  CHECK(report.evaluations < 32);

  // Another process takes it, until it is told to end.
  std::array<int, 2> ready{};
  std::array<int, 2> end{};
  REQUIRE(pipe(ready.data()) == 0);
  REQUIRE(pipe(end.data()) == 0);
  const pid_t child = fork();
  if (child == 0) {
    RunLock lock;
    char byte = lock.Take(prepared.path) ? 'n' : 'y';
    if (write(ready[1], &byte, 1) == 1 && read(end[0], &byte, 1) == 1)
      lock.Release();
    _exit(0);
  }
  char byte = 0;
  REQUIRE(read(ready[0], &byte, 1) == 1);
  REQUIRE(byte == 'y');
  report = ReportOn(prepared.folder, prepared.study, prepared.run);
  CHECK(report.state == RunState::kRunning);
  CHECK(report.worker.find(std::to_string(child)) != std::string::npos);
  REQUIRE(write(end[1], &byte, 1) == 1);
  waitpid(child, nullptr, 0);
  for (const int descriptor : {ready[0], ready[1], end[0], end[1]})
    close(descriptor);
  CHECK(ReportOn(prepared.folder, prepared.study, prepared.run).state ==
        RunState::kUnfinished);
}

TEST_CASE("Before its first generation a run has no best robot",
          "[run_report]") {
  const Prepared prepared(1);
  const RunReport report =
      ReportOn(prepared.folder, prepared.study, prepared.run);
  CHECK(report.state == RunState::kUnfinished);
  CHECK(report.generations == 0);
  CHECK(report.best.empty());
}

TEST_CASE("What is no run of the study is damaged, and says why",
          "[run_report]") {
  Prepared prepared(0);
  // A run of another seed.
  std::filesystem::copy_file(prepared.path,
                             RunPath(prepared.folder, prepared.study, {0, 2}));
  RunReport report = ReportOn(prepared.folder, prepared.study, {0, 2});
  CHECK(report.state == RunState::kDamaged);
  CHECK(report.problem.find("another experiment or seed") != std::string::npos);
  // Not a store.
  test::WriteBytes(RunPath(prepared.folder, prepared.study, {1, 1}), "text");
  report = ReportOn(prepared.folder, prepared.study, {1, 1});
  CHECK(report.state == RunState::kDamaged);
  CHECK(report.problem.find("baseline/1.sqlite") != std::string::npos);
}

}  // namespace plsc
