#include <catch2/catch.hpp>
#include <cstdlib>
#include <set>
#include <string>

#include "runtime/store/database.h"
#include "runtime/store/export.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {

namespace {

/// The records of RFC 4180, read by rules of our own.
std::vector<std::vector<std::string>> ReadCsv(const std::string& text) {
  std::vector<std::vector<std::string>> records(1, {""});
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (is_quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      records.back().back() += '"';
      ++i;
    } else if (c == '"') {
      is_quoted = !is_quoted;
    } else if (!is_quoted && c == ',') {
      records.back().emplace_back();
    } else if (!is_quoted && c == '\r') {
      continue;
    } else if (!is_quoted && c == '\n') {
      records.push_back({""});
    } else {
      records.back().back() += c;
    }
  }
  CHECK(records.back() == std::vector<std::string>{""});
  records.pop_back();
  return records;
}

std::string Csv(const std::string& run, const CsvTable& table) {
  std::string text;
  CsvExport tables;
  REQUIRE(tables.Open(run).value_or("").text == "");
  CHECK(tables.damage().value_or("").text == "");
  const auto failure = tables.Write(table, [&](std::string_view piece) {
    text += piece;
    return std::nullopt;
  });
  REQUIRE(failure.value_or("").text == "");
  return text;
}

/// By a rule of our own: the run's states are a bool and a real number.
std::string Typed(std::string text) {
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (std::size_t at; (at = text.find(from)) != text.npos;)
      text.replace(at, from.size(), to);
  };
  replace("\"True\"", "true");
  replace("\"False\"", "false");
  replace("\"30.5\"", "30.5");
  replace("\"-1e-3\"", "-0.001");
  return text;
}

const CsvTable& TableOf(const std::string& name) {
  for (const CsvTable& table : CsvTables())
    if (table.name == name) return table;
  FAIL("no table " << name);
  return CsvTables().front();
}

}  // namespace

TEST_CASE("Tables have a header and every value", "[export]") {
  const test::Scratch scratch;
  const std::string path = scratch / "run";
  test::WriteTriedRun(path);
  Database database;
  REQUIRE(database.Open(path, Database::Mode::kRead) == std::nullopt);
  for (const CsvTable& table : CsvTables()) {
    CAPTURE(table.name);
    const auto records = ReadCsv(Csv(path, table));
    Statement rows(database, table.sql);
    rows.With();
    REQUIRE(records.size() > 1);
    std::size_t r = 1;
    for (; rows.Next(); ++r) {
      REQUIRE(r < records.size());
      REQUIRE(records[r].size() == records[0].size());
      for (std::size_t i = 0; i < records[r].size(); ++i) {
        const char type = rows.Type();
        const std::string& column = records[0][i];
        if (column == "sensed" || column == "senses") {
          CHECK(records[r][i] == Typed(rows.TakeText()));
        } else if (type == 'r') {
          CHECK(std::strtod(records[r][i].c_str(), nullptr) == rows.TakeReal());
        } else {
          CHECK(records[r][i] == rows.TakeText());
        }
      }
    }
    CHECK(r == records.size());
    // A column is never there twice, as two tables may have the same name.
    CHECK(std::set<std::string>(records[0].begin(), records[0].end()).size() ==
          records[0].size());
  }
}

TEST_CASE("Genotypes in tables are whole", "[export]") {
  const test::Scratch scratch;
  test::WriteRun(scratch / "run", 1);
  const auto records = ReadCsv(Csv(scratch / "run", TableOf("individuals")));
  REQUIRE(records.size() == 1 + 8 + 6);  // header, initial, next generation
  CHECK(records[0].back() == "genotype");
  for (std::size_t i = 1; i < records.size(); ++i)
    CHECK(records[i].back().find("plsc 1\n\ngenotype robot_") == 0);
}

TEST_CASE("What the reader of a table refuses ends the writing", "[export]") {
  const test::Scratch scratch;
  test::WriteRun(scratch / "run", 1);
  int pieces = 0;
  CsvExport tables;
  REQUIRE_FALSE(tables.Open(scratch / "run"));
  const auto failure =
      tables.Write(TableOf("results"), [&](std::string_view) -> MaybeFailure {
        if (++pieces < 3) return std::nullopt;
        return "the disk is full";
      });
  CHECK(failure == "the disk is full");
  CHECK(pieces == 3);
  CHECK(CsvExport().Open(scratch / "none"));
}

TEST_CASE("Equal runs give equal files", "[export]") {
  const test::Scratch scratch;
  const test::Recorder run = test::RecordRun(test::StoredExperiment());
  for (const int order : {0, 1, 2}) {
    const std::string path = scratch / std::to_string(order);
    RunStore store;
    REQUIRE(store.Create(path, test::StoredExperiment()) == std::nullopt);
    REQUIRE(store.BeginSession({"2026-01-01T00:00:00Z", order}) ==
            std::nullopt);
    REQUIRE(test::Report(run, store, order, 3) == "");
    // While it is still written to.
    for (const CsvTable& table : CsvTables())
      if (order > 0) {
        // The half of the last generation that is evaluated is another one.
        const bool is_same = table.name != "results" && table.name != "robots";
        if (is_same) CHECK(Csv(path, table) == Csv(scratch / "0", table));
      }
    REQUIRE(store.Close() == std::nullopt);
  }
}

}  // namespace plsc
