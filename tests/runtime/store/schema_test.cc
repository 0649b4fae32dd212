#include "runtime/store/schema.h"

#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "runtime/develop/descriptors.h"
#include "runtime/store/database.h"
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
