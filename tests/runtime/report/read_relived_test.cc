#include "runtime/report/read_relived.h"

#include <catch2/catch.hpp>

#include "runtime/relive/relived_file.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {
namespace {

/// A stored run, and lives of its last generation's robots.
struct RelivedStore {
  test::Scratch scratch;
  std::string run = scratch / "1.sqlite";
  int last = 0;

  RelivedStore() {
    test::WriteRun(run);
    RunStore store;
    REQUIRE_FALSE(store.OpenForReading(run));
    last = store.Status()->generations - 1;
    const auto subjects = SubjectsOf(store, {});
    REQUIRE(subjects);
    RelivedFile file;
    REQUIRE_FALSE(file.OpenForWriting(RelivedPathOf(run), subjects->run));
    REQUIRE_FALSE(file.BeginRobots(subjects->Sums()));
    REQUIRE_FALSE(file.BeginEngine(false, ThisProgram()));
    for (const auto& [id, robot] : subjects->robots)
      for (int season = 0; season < 2; ++season) {
        RelivedSeason life;
        life.of = {id, false, season, season};
        life.n = 1;
        life.fitness = id;
        REQUIRE_FALSE(file.Add({life}));
      }
    REQUIRE_FALSE(file.Close());
  }
};

TEST_CASE("a report finds the lives of the generation that it compares",
          "[relived]") {
  const RelivedStore stored;
  const RelivedReading reading = ReadRelived(stored.run, stored.last);
  CHECK(reading.state == RelivedState::kHere);
  CHECK(reading.generation.lives == 1);
  double sum = 0;
  for (const RelivedRobotValues& robot : reading.generation.robots)
    sum += robot.id;
  CHECK(reading.generation.of(0, 1).mean ==
        Approx(sum / reading.generation.survivors));
}

TEST_CASE("lives of another generation are older than the run", "[relived]") {
  const RelivedStore stored;
  CHECK(ReadRelived(stored.run, 0).state == RelivedState::kOlder);
}

TEST_CASE("a run without such lives lacks them", "[relived]") {
  const test::Scratch scratch;
  test::WriteRun(scratch / "1.sqlite");
  CHECK(ReadRelived(scratch / "1.sqlite", 0).state == RelivedState::kMissing);
}

TEST_CASE("lives that cannot be read are told", "[relived]") {
  const RelivedStore stored;
  test::WriteBytes(RelivedPathOf(stored.run), "");
  const RelivedReading reading = ReadRelived(stored.run, stored.last);
  CHECK(reading.state == RelivedState::kUnusable);
  CHECK(reading.problem.find("1.relived.sqlite") != std::string::npos);
}

}  // namespace
}  // namespace plsc
