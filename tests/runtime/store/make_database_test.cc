#include "runtime/store/make_database.h"

#include <catch2/catch.hpp>
#include <string>

#include "tests/runtime/store/stored_run.h"

namespace plsc {

namespace {

using test::Scratch;

void Fill(Database& database) {
  database.Run("CREATE TABLE t(a); INSERT INTO t VALUES(7)");
}

}  // namespace

TEST_CASE("A database that is made is in WAL mode and whole",
          "[make_database]") {
  const Scratch scratch;
  const std::string path = scratch / "db";
  REQUIRE(MakeDatabase(path, Fill) == std::nullopt);
  CHECK(scratch.Files() == std::vector<std::string>{"db"});
  Database database;
  REQUIRE(database.Open(path, Database::Mode::kWrite) == std::nullopt);
  Statement mode(database, "PRAGMA journal_mode");
  REQUIRE(mode.Next());
  CHECK(mode.TakeText() == "wal");
  Statement value(database, "SELECT a FROM t");
  REQUIRE(value.Next());
  CHECK(value.TakeInt() == 7);
  Statement check(database, "PRAGMA integrity_check");
  REQUIRE(check.Next());
  CHECK(check.TakeText() == "ok");
}

TEST_CASE("A database that cannot be made is not there", "[make_database]") {
  const Scratch scratch;
  const std::string path = scratch / "db";
  CHECK(MakeDatabase(path, [](Database& database) {
    database.Run("CREATE TABLE t(a); wrong");
  }));
  CHECK(MakeDatabase(path, Fill, [](int) { return "not so"; }) == "not so");
  CHECK(scratch.Files().empty());
  REQUIRE(MakeDatabase(path, Fill) == std::nullopt);
  const std::string bytes = test::ReadBytes(path);
  CHECK(MakeDatabase(path, Fill) ==
        "cannot write to '" + path + "': File exists");
  CHECK(test::ReadBytes(path) == bytes);
}

TEST_CASE("Two databases have not the same number", "[make_database]") {
  const Scratch scratch;
  for (const char* name : {"a", "b"})
    REQUIRE(MakeDatabase(scratch / name, Fill) == std::nullopt);
  CHECK(test::ReadBytes(scratch / "a") != test::ReadBytes(scratch / "b"));
}

}  // namespace plsc
