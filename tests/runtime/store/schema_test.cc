#include "runtime/store/schema.h"

#include <catch2/catch.hpp>
#include <cmath>
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

TEST_CASE("Older schemas differ in what they lack alone", "[schema]") {
  const auto& now = Schema();
  for (const int version : {1, 2, 3, 4}) {
    const auto& older = Schema(version);
    std::set<std::string> changed;
    auto same = older.begin();
    for (const SchemaItem& item : now) {
      if (version < 4 && item.name == "trial") continue;
      REQUIRE(same != older.end());
      CHECK(same->name == item.name);
      if (same->sql != item.sql) changed.insert(item.name);
      ++same;
    }
    CHECK(same == older.end());
    std::set<std::string> expected = {"simulation", "result"};
    if (version < 3) expected.insert("generation");
    if (version == 1) expected.insert("run");
    CHECK(changed == expected);
  }
  CHECK(MissingMeasures(kSchemaVersion).empty());
  const std::vector<std::string> ends = {
      "final_x", "final_y",           "final_z",
      "heading", "straightness",      "turning",
      "energy",  "cost_of_transport", "target_distance"};
  CHECK(MissingMeasures(3) == ends);
  CHECK(MissingMeasures(4) == ends);
  std::vector<std::string> all = {"servo_error_median", "servo_error_worst",
                                  "core_turns"};
  all.insert(all.end(), ends.begin(), ends.end());
  CHECK(MissingMeasures(2) == all);
}

struct OlderStore {
  const char* file;
  int schema;
  int results;
  const char* plsc;
  const char* refused;
  bool has_servo_errors = false;
  bool has_trials = false;
};

constexpr OlderStore kOlderStores[] = {
    {"run_schema_1.sqlite", 1, 1, "0.1.0",
     "was made by other arithmetic: its results have number 1 (plsc 0.1.0)"},
    {"run_schema_2.sqlite", 2, 2, "0.2.0",
     "is a store of schema 2, and this program's have 5: its lives lack "
     "servo_error_median, servo_error_worst, core_turns, final_x, "},
    {"run_schema_3.sqlite", 3, 2, "0.2.0",
     "is a store of schema 3, and this program's have 5: its lives lack "
     "final_x, ",
     true},
    {"run_schema_4.sqlite", 4, 2, "0.2.0",
     "is a store of schema 4, and this program's have 5: its lives lack "
     "final_x, ",
     true, true},
};

TEST_CASE("A store of an older schema is read as one of this", "[schema]") {
  for (const OlderStore& older : kOlderStores) {
    INFO(older.file);
    const test::Scratch scratch;
    const std::string path = scratch / "run";
    std::filesystem::copy_file(
        std::string(PLSC_SOURCE_DIR "/tests/data/") + older.file, path);
    const std::string before = test::ReadBytes(path);
    RunStore store;
    REQUIRE(store.OpenForReading(path) == std::nullopt);
    CHECK(store.schema() == older.schema);
    CHECK(store.versions().results == older.results);
    CHECK(store.versions().plsc == older.plsc);
    CHECK(store.experiment().name == "older");
    const auto best = store.Find(store.Status()->best);
    REQUIRE(best);
    REQUIRE(best->evaluation.seasons.size() == 2);
    // Not known, and not 0.
    const Behaviour& behaviour = best->evaluation.seasons[0].behaviour;
    CHECK(behaviour.is_valid);
    CHECK(std::isfinite(behaviour.contacts));
    CHECK(std::isnan(behaviour.servo_error_median) != older.has_servo_errors);
    CHECK(std::isnan(behaviour.core_turns) != older.has_servo_errors);
    CHECK(std::isnan(behaviour.final_x));
    CHECK(std::isnan(behaviour.energy));
    CHECK(store.TrialsOf(1)->empty() != older.has_trials);
    REQUIRE(store.Close() == std::nullopt);
    CHECK(Examine(path).problem == std::nullopt);
    CHECK(Examine(path).whole_generations == 2);
    // Only whole simulations can be used, and nothing is added to it.
    Salvage salvage;
    REQUIRE(salvage.Open(path) == std::nullopt);
    CHECK(salvage.versions().results == older.results);
    CHECK(salvage.schema() == older.schema);
    CHECK(salvage.experiment());
    CHECK(salvage.size() == 0);
    const auto refused = store.Open(path);
    REQUIRE(refused);
    CHECK(refused->text.find(older.refused) != std::string::npos);
    const auto always = store.Open(path, true);
    REQUIRE(always);
    CHECK(always->text.find("is a store of schema") != std::string::npos);
    CHECK(test::ReadBytes(path) == before);
  }
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
