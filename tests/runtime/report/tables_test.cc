#include "runtime/report/tables.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/runtime/report/claimed_study.h"

namespace plsc {

namespace {

std::vector<Table> Tables(const StudyReport& report) {
  return TablesOf(report, ClaimResultsOf(report));
}

/// The cell of the first row, of the column.
std::string At(const Table& table, const std::string& column,
               std::size_t row = 0) {
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (table.columns[i] == column) return table.rows.at(row).at(i);
  return "no such column";
}

}  // namespace

TEST_CASE("Tables have a report's claims, boxes, tests and runs", "[tables]") {
  StudyReport report = test::RelivedClaims();
  report.title = "a|b";
  report.runs[0].input.label = "a/1";
  const auto tables = Tables(report);
  REQUIRE(tables.size() == 5);
  for (const Table& table : tables) {
    INFO(table.name);
    CHECK(TableCsv(table).starts_with(kTableMark));
    for (const auto& row : table.rows)
      CHECK(row.size() == table.columns.size());
  }
  const Table& claims = tables[0];
  REQUIRE(claims.rows.size() == 3);
  CHECK(At(claims, "claim") == "bigger");
  CHECK(At(claims, "values", 1) == "relived");
  CHECK(At(claims, "verdict", 1) == "holds");
  CHECK(At(claims, "told first", 1) == "yes");
  CHECK(At(claims, "verdict", 2) == "opposite");
  CHECK(At(claims, "second median", 1) == "98");
  CHECK(At(claims, "p") == "0.00793651");
  const Table& boxes = tables[1];
  CHECK(At(boxes, "values") == "relived");
  CHECK(At(boxes, "measure") == "Speed (cm/s)");
  CHECK(At(boxes, "median") == "88");
  CHECK(At(tables[2], "p") == "0.00793651");
  const Table& runs = tables[4];
  CHECK(runs.rows.size() == 2 * 2 * 10);
  CHECK(At(runs, "run") == "a/1");
  CHECK(At(runs, "Speed (cm/s)") == "90");
  CHECK(At(runs, "Speed (cm/s)", 1) == "10");
  CHECK(At(runs, "Size (modules) of the best", 0).empty());
  CHECK(At(runs, "Size (modules) of the best", 1) == "20");
}

TEST_CASE("Tables as Markdown leave out what is empty, and keep names whole",
          "[tables]") {
  StudyReport report = test::ClaimedStudy(
      {test::SizeClaim(ClaimKind::kGreater, "big|ger\n<b>")});
  report.title = "a|b";
  const std::string text = TablesMarkdown(report, Tables(report));
  INFO(text);
  CHECK(text.starts_with(std::string(kTablesMark) + "\n\n# a\\|b\n"));
  CHECK(text.find("| recorded | big\\|ger \\<b> | holds |") !=
        std::string::npos);
  CHECK(text.find("minimum") == std::string::npos);
  CHECK(text.find("What plastic robots lose") == std::string::npos);
}

TEST_CASE("Without a report tables are empty, but there", "[tables]") {
  for (const Table& table : TablesOf({}, {})) {
    CHECK(table.rows.empty());
    CHECK(TableCsv(table).starts_with(kTableMark));
  }
}

}  // namespace plsc
