#include "runtime/report/read_run.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "runtime/study/study_folder.h"
#include "tests/runtime/store/stored_run.h"
#include "tests/runtime/study/small_study.h"

namespace plsc {
namespace {

ReadOptions Paper() {
  return {PaperMeasures(), false};
}

}  // namespace

TEST_CASE("A run is read with its state, wherever it stands", "[read_run]") {
  const test::Scratch scratch;
  const std::string path = scratch / "run";
  const Experiment experiment = ExperimentOf(test::SmallStudy(), {0, 1});
  CHECK(ReadRun(path, Paper()).state == RunState::kMissing);

  REQUIRE(test::Execute({{0, 1}, path, experiment, false}, 16) ==
          RunEnd::kStopped);
  const RunReading half = ReadRun(path, Paper(), experiment);
  CHECK(half.state == RunState::kUnfinished);
  CHECK(half.population.generations >= 1);
  CHECK(half.population.generations < 5);
  CHECK(half.best);

  REQUIRE(test::Execute({{0, 1}, path, experiment, true}) == RunEnd::kFinished);
  const RunReading done = ReadRun(path, Paper(), experiment);
  CHECK(done.state == RunState::kDone);
  CHECK(done.experiment == experiment);
  CHECK(done.population.generations == 5);
  CHECK(done.best->id == done.facts.best);
  CHECK_FALSE(done.rules.empty());
  // Only the store is there, as it was.
  CHECK(scratch.Files() == std::vector<std::string>{"run"});
}

TEST_CASE("A run is read while it is written", "[read_run]") {
  const test::Scratch scratch;
  const std::string path = scratch / "run";
  const test::Recorder recorder = test::RecordRun(test::StoredExperiment());
  RunStore store;
  REQUIRE_FALSE(store.Create(path, test::StoredExperiment()));
  REQUIRE(test::Report(recorder, store, 0, 2).empty());
  // Its journal holds all of it.
  const RunReading reading = ReadRun(path, Paper());
  CHECK(reading.problem.empty());
  CHECK(reading.population.generations == 2);
}

TEST_CASE("A baseline's rules have no clauses to be counted", "[read_run]") {
  const test::Scratch scratch;
  const std::string path = scratch / "run";
  const Experiment experiment = ExperimentOf(test::SmallStudy(), {1, 1});
  REQUIRE(test::Execute({{1, 1}, path, experiment, false}) ==
          RunEnd::kFinished);
  const RunReading reading = ReadRun(path, Paper());
  CHECK(reading.state == RunState::kDone);
  CHECK(reading.rules.empty());
  CHECK(reading.population.censuses.back().plastic_bodies == 0);
}

TEST_CASE("What cannot be read, or is another run, is damaged and says why",
          "[read_run]") {
  const test::Scratch scratch;
  const std::string path = scratch / "run";
  const Experiment experiment = ExperimentOf(test::SmallStudy(), {0, 1});
  REQUIRE(test::Execute({{0, 1}, path, experiment, false}) ==
          RunEnd::kFinished);
  const RunReading other =
      ReadRun(path, Paper(), ExperimentOf(test::SmallStudy(), {0, 2}));
  CHECK(other.state == RunState::kDamaged);
  CHECK(other.problem.find("another experiment or seed") != std::string::npos);

  const std::string whole = test::ReadBytes(path);
  test::WriteBytes(path, whole.substr(0, whole.size() / 2));
  const RunReading cut = ReadRun(path, Paper());
  CHECK(cut.state == RunState::kDamaged);
  CHECK(cut.problem.find(path) != std::string::npos);
  CHECK_FALSE(cut.best);

  // Garbage in any of its pages: a message or a reading, never a crash.
  for (std::size_t at = 0; at < whole.size(); at += 4096) {
    std::string bytes = whole;
    for (std::size_t i = at; i < std::min(at + 200, bytes.size()); ++i)
      bytes[i] = static_cast<char>(bytes[i] ^ 0x55);
    test::WriteBytes(path, bytes);
    const RunReading reading = ReadRun(path, Paper());
    CHECK((reading.state == RunState::kDamaged) == !reading.problem.empty());
  }
}

}  // namespace plsc
