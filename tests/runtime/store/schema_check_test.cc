#include "runtime/store/schema_check.h"

#include <catch2/catch.hpp>
#include <string>

#include "runtime/store/shared_cache.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {

namespace {

void ChangeStore(const std::string& path, const std::string& sql) {
  Database database;
  REQUIRE(database.Open(path, Database::Mode::kWrite) == std::nullopt);
  database.Run(sql);
  REQUIRE(database.TakeFailure() == std::nullopt);
}

}  // namespace

TEST_CASE("Nothing is written to a store with what we did not make",
          "[schema_check]") {
  struct Row {
    const char* sql;
    const char* what;
  };
  const Row rows[] = {
      {"CREATE TRIGGER extra AFTER INSERT ON evaluation BEGIN "
       "UPDATE evaluation SET fitness = 9; END",
       "a trigger 'extra'"},
      // Triggers have names of their own.
      {"CREATE TRIGGER run AFTER INSERT ON evaluation BEGIN "
       "DELETE FROM member; END",
       "a trigger 'run'"},
      {"CREATE VIEW extra AS SELECT 1", "a view 'extra'"},
      {"CREATE TABLE extra(a)", "a table 'extra'"},
      {"CREATE INDEX extra ON evaluation(fitness)", "an index 'extra'"},
  };
  for (const Row& row : rows) {
    CAPTURE(row.sql);
    const test::Scratch scratch;
    const std::string path = scratch / "run";
    test::WriteRun(path, 1);
    ChangeStore(path, row.sql);
    const std::string bytes = test::ReadBytes(path);
    RunStore store;
    CHECK(store.Open(path).value_or("").text.find(row.what) !=
          std::string::npos);
    CHECK(test::ReadBytes(path) == bytes);
    CHECK(scratch.Files() == std::vector<std::string>{"run"});
  }
}

TEST_CASE("A cache with a trigger is refused", "[schema_check]") {
  const test::Scratch scratch;
  const std::string path = scratch / "cache";
  REQUIRE(SharedCache().Open(path) == std::nullopt);
  REQUIRE(SharedCache().Open(path) == std::nullopt);
  ChangeStore(path,
              "CREATE TRIGGER extra AFTER INSERT ON simulation BEGIN "
              "DELETE FROM engine; END");
  CHECK(SharedCache().Open(path).value_or("").text.find("a trigger 'extra'") !=
        std::string::npos);
}

TEST_CASE("What SQLite finds out about a store is no change of it",
          "[schema_check]") {
  const test::Scratch scratch;
  const std::string path = scratch / "run";
  test::WriteRun(path, 1);
  ChangeStore(path, "ANALYZE");
  RunStore store;
  CHECK(store.Open(path) == std::nullopt);
}

}  // namespace plsc
