#include "runtime/relive/relived_file.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "runtime/store/database.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {
namespace {

using test::Scratch;

RunIdentity SomeRun() {
  return {"run.sqlite", "stored", "17", 4711, {"flat", "hill"}};
}

RelivedSeason SomeLife(int id, int n) {
  RelivedSeason life;
  life.of = {id, false, n % 2, 1};
  life.n = n;
  life.lift = 1e-6 * n + 1e-17;
  life.outcome = Outcome::kCompleted;
  life.behaviour.is_valid = true;
  life.behaviour.displacement_velocity_hill = -1.0 / 3;
  life.behaviour.displacement_velocity = -0.0;
  life.behaviour.velocity = 5e-324;
  life.fitness = -1.0 / 30;
  life.state_hash = ~std::uint64_t{5};
  life.steps = 10000;
  life.solver_warnings = 2;
  return life;
}

RelivedSeason FailedLife(int id, int n) {
  RelivedSeason life;
  life.of = {id, true, 0, 0};
  life.n = n;
  life.outcome = Outcome::kUnstable;
  life.reason = "faster than \"it\" may";
  return life;
}

void CheckSame(const RelivedSeason& a, const RelivedSeason& b) {
  CHECK(a.of == b.of);
  CHECK(a.n == b.n);
  CHECK(a.lift == b.lift);
  CHECK(a.outcome == b.outcome);
  CHECK(a.reason == b.reason);
  CHECK(MeasuresOf(a.behaviour, a.fitness) ==
        MeasuresOf(b.behaviour, b.fitness));
  CHECK(a.state_hash == b.state_hash);
  CHECK(a.steps == b.steps);
  CHECK(a.solver_warnings == b.solver_warnings);
}

void WriteLives(const std::string& path) {
  RelivedFile file;
  REQUIRE_FALSE(file.OpenForWriting(path, SomeRun()));
  REQUIRE_FALSE(file.BeginRobots({{3, 33}, {4, 44}}));
  REQUIRE_FALSE(
      file.BeginEngine(false, VersionsFor(test::StoredExperiment().scenario)));
  REQUIRE_FALSE(file.BeginEngine(true, ThisProgram()));
  REQUIRE_FALSE(file.Add({SomeLife(4, 1), FailedLife(3, 1)}));
  REQUIRE_FALSE(file.Add({SomeLife(3, 2)}));
  REQUIRE_FALSE(file.Close());
}

std::string Problem(const std::string& path,
                    const RunIdentity& run = SomeRun()) {
  RelivedFile file;
  const MaybeFailure failure = file.OpenForReading(path, run);
  if (failure) return failure->text;
  const auto lives = file.Lives();
  return lives ? "" : lives.error().text;
}

TEST_CASE("lives come back as they were, in order, and from one file",
          "[relive]") {
  const Scratch scratch;
  const std::string path = scratch / "1.relived.sqlite";
  WriteLives(path);
  CHECK(scratch.Files() == std::vector<std::string>{"1.relived.sqlite"});
  RelivedFile file;
  REQUIRE_FALSE(file.OpenForReading(path, SomeRun()));
  const auto lives = file.Lives();
  REQUIRE(lives);
  REQUIRE(lives->size() == 3);
  CheckSame((*lives)[0], SomeLife(3, 2));
  CheckSame((*lives)[1], FailedLife(3, 1));
  CheckSame((*lives)[2], SomeLife(4, 1));
}

TEST_CASE("a life that is lived anew replaces the one before", "[relive]") {
  const Scratch scratch;
  const std::string path = scratch / "1.relived.sqlite";
  WriteLives(path);
  RelivedFile file;
  REQUIRE_FALSE(file.OpenForWriting(path, SomeRun()));
  RelivedSeason again = SomeLife(4, 1);
  again.steps = 7;
  REQUIRE_FALSE(file.Add({again}));
  const auto lives = file.Lives();
  REQUIRE(lives);
  REQUIRE(lives->size() == 3);
  CHECK(lives->back().steps == 7);
}

TEST_CASE("a file is of one run and of its robots", "[relive]") {
  const Scratch scratch;
  const std::string path = scratch / "1.relived.sqlite";
  WriteLives(path);
  RunIdentity other = SomeRun();
  other.path = "other.sqlite";
  ++other.checksum;
  CHECK(Problem(path, other) ==
        "'" + path + "' is of another run than 'other.sqlite': delete '" +
            path + "', or move it away, to begin anew");
  RelivedFile file;
  REQUIRE_FALSE(file.OpenForWriting(path, SomeRun()));
  CHECK_FALSE(file.CheckRobots({{3, 33}, {9, 99}}));
  const auto problem = file.CheckRobots({{3, 34}});
  REQUIRE(problem);
  CHECK(problem->text.find("robot 3 is another there") != std::string::npos);
  CHECK(file.BeginRobots({{4, 45}}));
}

TEST_CASE("lives of two programs are not mixed", "[relive]") {
  const Scratch scratch;
  const std::string path = scratch / "1.relived.sqlite";
  WriteLives(path);
  RelivedFile file;
  REQUIRE_FALSE(file.OpenForWriting(path, SomeRun()));
  CHECK_FALSE(file.BeginEngine(true, ThisProgram()));
  Versions newer = ThisProgram();
  ++newer.results;
  const auto problem = file.BeginEngine(true, newer);
  REQUIRE(problem);
  CHECK(problem->text.find("those of this one would differ") !=
        std::string::npos);
}

TEST_CASE("one process at a time adds to it, and others read", "[relive]") {
  const Scratch scratch;
  const std::string path = scratch / "1.relived.sqlite";
  WriteLives(path);
  RelivedFile file;
  REQUIRE_FALSE(file.OpenForWriting(path, SomeRun()));
  REQUIRE_FALSE(file.Add({SomeLife(4, 3)}));
  RelivedFile second;
  const auto refused = second.OpenForWriting(path, SomeRun());
  REQUIRE(refused);
  CHECK(refused->text.find("is in use by process") != std::string::npos);
  CHECK(Problem(path) == "");
}

TEST_CASE("what is none of these files is refused, and stays as it is",
          "[relive]") {
  const Scratch scratch;
  struct Row {
    const char* why;
    std::string bytes;
    std::string said;
  };
  WriteLives(scratch / "whole.relived.sqlite");
  test::WriteRun(scratch / "run.sqlite");
  const std::string whole = test::ReadBytes(scratch / "whole.relived.sqlite");
  for (const Row& row : std::vector<Row>{
           {"empty", "", "empty"},
           {"a text", "plsc 1\n", "is no SQLite file"},
           {"a run", test::ReadBytes(scratch / "run.sqlite"),
            "is not of lives that were lived again"},
           {"cut off", whole.substr(0, whole.size() / 2), "damaged"}}) {
    INFO(row.why);
    const std::string path = scratch / "it.relived.sqlite";
    test::WriteBytes(path, row.bytes);
    INFO(Problem(path));
    CHECK(Problem(path).find(row.said) != std::string::npos);
    RelivedFile file;
    CHECK(file.OpenForWriting(path, SomeRun()));
    CHECK(test::ReadBytes(path) == row.bytes);
  }
}

TEST_CASE("numbers that were changed behind its back are found", "[relive]") {
  for (const char* sql :
       {"UPDATE life SET fitness = 1", "UPDATE life SET lift = 0",
        "UPDATE life SET n = 9 WHERE n = 2",
        "UPDATE life SET displacement_velocity_hill = 1 WHERE is_valid",
        "UPDATE life SET season = 77", "UPDATE life SET outcome = 'well'",
        "UPDATE life SET state_hash = 'none'",
        "UPDATE life SET reason = 'none'", "UPDATE life SET checksum = 0"}) {
    INFO(sql);
    const Scratch scratch;
    const std::string path = scratch / "1.relived.sqlite";
    WriteLives(path);
    {
      Database database;
      REQUIRE_FALSE(database.Open(path, Database::Mode::kWrite));
      database.Run("PRAGMA foreign_keys = OFF");
      database.Run(sql);
      REQUIRE_FALSE(database.TakeFailure());
    }
    CHECK(Problem(path).find("a life is not what was written") !=
          std::string::npos);
  }
}

TEST_CASE("nothing that somebody added to the schema is run", "[relive]") {
  const Scratch scratch;
  const std::string path = scratch / "1.relived.sqlite";
  WriteLives(path);
  {
    Database database;
    REQUIRE_FALSE(database.Open(path, Database::Mode::kWrite));
    database.Run(
        "CREATE TRIGGER extra AFTER INSERT ON life BEGIN DELETE FROM robot; "
        "END");
    REQUIRE_FALSE(database.TakeFailure());
  }
  CHECK(Problem(path).find("trigger 'extra'") != std::string::npos);
}

TEST_CASE("files of relived lives are known from runs", "[relive]") {
  CHECK(RelivedPathOf("a/1.sqlite") == "a/1.relived.sqlite");
  CHECK(RelivedPathOf("a/run") == "a/run.relived.sqlite");
  const Scratch scratch;
  WriteLives(scratch / "renamed.sqlite");
  test::WriteRun(scratch / "1.sqlite");
  test::WriteRun(scratch / "odd.relived.sqlite");
  test::WriteBytes(scratch / "empty.relived.sqlite", "");
  test::WriteBytes(scratch / "empty.sqlite", "");
  CHECK(IsRelivedFile(scratch / "renamed.sqlite"));
  CHECK_FALSE(IsRelivedFile(scratch / "1.sqlite"));
  CHECK_FALSE(IsRelivedFile(scratch / "odd.relived.sqlite"));
  CHECK(IsRelivedFile(scratch / "empty.relived.sqlite"));
  CHECK_FALSE(IsRelivedFile(scratch / "empty.sqlite"));
  CHECK_FALSE(IsRelivedFile(scratch / "none.relived.sqlite"));
}

}  // namespace
}  // namespace plsc
