#include "runtime/store/schema.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <set>
#include <string>

#include "runtime/develop/descriptors.h"
#include "runtime/store/database.h"
#include "runtime/store/salvage.h"
#include "runtime/store/verify.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {

TEST_CASE("Every descriptor is a column of the results", "[schema]") {
  const test::Scratch scratch;
  test::WriteRun(scratch / "run", 1);
  Database database;
  REQUIRE(database.Open(scratch / "run", Database::Mode::kRead) ==
          std::nullopt);
  const Statement rows(database, "SELECT * FROM result");
  std::set<std::string> columns;
  for (int i = 0; i < rows.columns(); ++i)
    CHECK(columns.insert(rows.ColumnName(i)).second);
  for (const auto& list :
       {List(BodyDescriptors{}), List(BrainDescriptors{}), List(Behaviour{})})
    for (const NamedValue& value : list)
      CHECK(columns.contains(std::string(value.name)));
}

TEST_CASE("The schema's items can be compared row by row", "[schema]") {
  const test::Scratch scratch;
  test::WriteRun(scratch / "run", 1);
  Database database;
  REQUIRE(database.Open(scratch / "run", Database::Mode::kRead) ==
          std::nullopt);
  for (const SchemaItem& item : Schema()) {
    CAPTURE(item.name);
    if (item.kind == SchemaKind::kTable) {
      // What orders rows tells each from each.
      Statement twice(database, "SELECT count(*) FROM " + item.name +
                                    " GROUP BY " + item.order +
                                    " HAVING count(*) > 1");
      CHECK_FALSE(twice.With().Next());
    }
    CHECK(database.TakeFailure() == std::nullopt);
  }
}

TEST_CASE("The first schema differs in what the run is alone", "[schema]") {
  const auto& first = Schema(kOldestSchema);
  const auto& now = Schema();
  REQUIRE(first.size() == now.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    CAPTURE(now[i].name);
    CHECK(first[i].name == now[i].name);
    CHECK((first[i].sql == now[i].sql) == (now[i].name != "run"));
  }
}

TEST_CASE("A store of the first schema is read as one of this", "[schema]") {
  const test::Scratch scratch;
  const std::string path = scratch / "run";
  std::filesystem::copy_file(PLSC_SOURCE_DIR "/tests/data/run_schema_1.sqlite",
                             path);
  const std::string before = test::ReadBytes(path);
  RunStore store;
  REQUIRE(store.OpenForReading(path) == std::nullopt);
  CHECK(store.versions().results == 1);
  CHECK(store.versions().plsc == "0.1.0");
  CHECK(store.experiment().name == "older");
  CHECK(UsesOde(store.experiment().scenario));
  const auto best = store.Find(store.Status()->best);
  REQUIRE(best);
  CHECK(best->evaluation.seasons.size() == 2);
  REQUIRE(store.Close() == std::nullopt);
  CHECK(Examine(path).problem == std::nullopt);
  CHECK(Examine(path).whole_generations == 2);
  // Refused, and not changed.
  const auto refused = store.Open(path);
  REQUIRE(refused);
  CHECK(refused->text.find("was made by other arithmetic: its results have "
                           "number 1 (plsc 0.1.0)") != std::string::npos);
  CHECK(test::ReadBytes(path) == before);
  // Who wants it all the same adds to it, in its schema.
  REQUIRE(store.Open(path, true) == std::nullopt);
  REQUIRE(store.BeginSession({"2026-01-01T00:00:00Z", 1}) == std::nullopt);
  REQUIRE(store.EndSession({"2026-01-01T00:01:00Z", "finished", 1, 0, 0, 0, 1,
                            1}) == std::nullopt);
  REQUIRE(store.Close() == std::nullopt);
  CHECK(Examine(path).problem == std::nullopt);
  Salvage salvage;
  REQUIRE(salvage.Open(path) == std::nullopt);
  CHECK(salvage.versions().results == 1);
  CHECK(salvage.size() > 0);
}

TEST_CASE("The view of what comes next is where the run stands", "[schema]") {
  const test::Scratch scratch;
  for (int generations = 0; generations <= 2; ++generations) {
    const std::string path = scratch / std::to_string(generations);
    test::WriteRun(path, generations);
    Database database;
    REQUIRE(database.Open(path, Database::Mode::kRead) == std::nullopt);
    Statement next(database, "SELECT seed, generation, id FROM next");
    REQUIRE(next.With().Next());
    CHECK(next.TakeText() == "18364758544493064720");
    CHECK(next.TakeInt() == generations);
    CHECK(next.TakeInt() == (generations == 0 ? 1 : 3 + 6 * generations));
  }
}

}  // namespace plsc
