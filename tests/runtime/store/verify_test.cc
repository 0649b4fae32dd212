#include "runtime/store/verify.h"

#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "runtime/store/result_dump.h"
#include "runtime/store/schema.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {

namespace {

using test::ReadBytes;
using test::Scratch;
using test::WriteBytes;
using test::WriteRun;

/// Changes a store behind its back, as no program should.
void Tamper(const std::string& path, const std::string& sql) {
  Database database;
  REQUIRE(database.Open(path, Database::Mode::kWrite) == std::nullopt);
  database.Run("PRAGMA foreign_keys = OFF");
  database.Run(sql);
  REQUIRE(database.TakeFailure() == std::nullopt);
  database.Close();
}

std::string OpenFailure(const std::string& path) {
  RunStore store;
  return store.Open(path).value_or("").text;
}

bool Contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("A whole store has nothing wrong", "[verify]") {
  const Scratch scratch;
  for (int generations = 0; generations <= 5; ++generations) {
    const std::string path = scratch / std::to_string(generations);
    WriteRun(path, generations);
    const Health health = Examine(path);
    CHECK(health.problem == std::nullopt);
    CHECK(health.whole_generations == generations);
  }
}

TEST_CASE("Every value of every result table is under a checksum",
          "[verify][slow]") {
  const Scratch scratch;
  const std::string whole = scratch / "whole";
  test::WriteTriedRun(whole);
  CHECK(Examine(whole).problem == std::nullopt);
  for (const SchemaItem& item : Schema()) {
    if (item.kind != SchemaKind::kTable || !item.is_result) continue;
    Database database;
    REQUIRE(database.Open(whole, Database::Mode::kRead) == std::nullopt);
    Statement all(database, "SELECT * FROM " + item.name);
    std::vector<std::string> columns;
    for (int i = 0; i < all.columns(); ++i)
      columns.push_back(all.ColumnName(i));
    for (const std::string& column : columns) {
      CAPTURE(item.name, column);
      const std::string path = scratch / "tampered";
      std::filesystem::copy_file(
          whole, path, std::filesystem::copy_options::overwrite_existing);
      // One row that is neither first nor last, where there are three.
      const std::string rows = " FROM " + item.name + " ORDER BY " +
                               item.order +
                               " LIMIT 1 OFFSET min(5, (SELECT "
                               "count(*) / 2 FROM " +
                               item.name + "))";
      std::string key = item.order;
      Tamper(path, "PRAGMA ignore_check_constraints = ON; UPDATE OR REPLACE " +
                       item.name + " SET " + column + " = CASE typeof(" +
                       column + ") WHEN 'integer' THEN " + column +
                       " + 1 WHEN 'real' THEN " + column +
                       " * 1.5 + 1e-300 WHEN 'null' THEN 7 ELSE " + column +
                       " || 'x' END WHERE (" + key + ") IN (SELECT " + key +
                       rows + ")");
      // Ids of headers and hashes of rules are only ways to find them.
      const Health health = Examine(path);
      const bool is_mere_index = (item.name == "rule" && column == "hash") ||
                                 (item.name == "run" && column == "id");
      if (!is_mere_index) CHECK(health.problem);
    }
  }
}

TEST_CASE("What is damaged is named, with what is whole before it",
          "[verify]") {
  const Scratch scratch;
  struct Row {
    const char* why;
    const char* sql;
    const char* message;
    int whole;
  };
  const std::vector<Row> rows = {
      {"a fitness", "UPDATE evaluation SET fitness = 1 WHERE individual = 9",
       "the evaluation of robot 9 is not what it was; generations 0 to 0 are "
       "whole",
       1},
      {"a parent",
       "UPDATE individual SET parent1 = 3 - parent2 % 2 "
       "WHERE id = 15",
       "robot 15 is not as it was born; generations 0 to 1 are whole", 2},
      {"a rule", "UPDATE rule SET text = text || ' ' WHERE id = 1",
       "is not as it was born; no generation of it is whole", 0},
      {"a rule is missing",
       "DELETE FROM genotype_rule WHERE individual = 2 AND position = 0",
       "robot 2 is not as it was born; no generation of it is whole", 0},
      {"a robot is missing", "DELETE FROM individual WHERE id = 14",
       "a row of '", 1},
      {"an evaluation is missing",
       "DELETE FROM evaluation WHERE individual = 20 AND season = 1",
       "robot 20 lacks an evaluation; generations 0 to 1 are whole", 2},
      {"a survivor",
       "UPDATE member SET survivor = 99 WHERE generation = 1 "
       "AND survivor = 0",
       "generation 1 is not what it was; generations 0 to 0 are whole", 1},
      {"a generation is missing", "DELETE FROM generation WHERE number = 1",
       "a generation is missing", 0},
      {"one who is too much",
       "INSERT INTO individual SELECT 99, name, 3, NULL, NULL, from_second, "
       "mutation, mutated_rule, senses, header, checksum FROM individual "
       "WHERE id = 1",
       "generation 3 lacks robots; generations 0 to 2 are whole", 3},
      {"the experiment",
       "UPDATE run SET experiment = replace(experiment, 'seed:', 'seed: ')",
       "what the run is cannot be trusted", 0},
      {"a constant", "UPDATE physics SET value = 2 WHERE name = 'servo.gain'",
       "what the run is cannot be trusted", 0},
      {"no run", "DELETE FROM run", "does not say what the run is", 0},
      {"another table", "ALTER TABLE rule ADD COLUMN mine",
       "its tables are not those of a run", 0},
      {"a newer one", "PRAGMA user_version = 6",
       "was made by a newer plsc (its schema is 6, this program knows 5)", 0},
      {"one that says to be older", "PRAGMA user_version = 1",
       "its tables are not those of a run", 0},
      {"an older one", "PRAGMA user_version = 0",
       "has schema 0, which this program does not read", 0},
      {"another program's", "PRAGMA application_id = 1",
       "is no run of plsc, but another program's file", 0},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const std::string path = scratch / "run";
      WriteRun(path, 3);
      Tamper(path, row.sql);
      const std::string before = ReadBytes(path);
      const Health health = Examine(path);
      REQUIRE(health.problem);
      CAPTURE(health.problem->text);
      CHECK(Contains(health.problem->text, row.message));
      CHECK(Contains(health.problem->text, path));
      CHECK(health.whole_generations == row.whole);
      // Neither is it gone on with, nor changed.
      CHECK(Contains(OpenFailure(path), row.message));
      CHECK(ReadBytes(path) == before);
      CHECK(scratch.Files() == std::vector<std::string>{"run"});
    }
  }
}

TEST_CASE("What is no store is refused and left alone", "[verify]") {
  const Scratch scratch;
  const std::string path = scratch / "run";
  WriteRun(path, 2);
  const std::string whole = ReadBytes(path);
  struct Row {
    const char* why;
    std::string bytes;
    const char* message;
  };
  const std::vector<Row> rows = {
      {"nothing", "", "' is empty"},
      {"a text", std::string(5000, 'x'), "is no SQLite file"},
      {"a short text", "plsc 1\n", "is no SQLite file"},
      {"the first page", whole.substr(0, 4096), "damaged"},
      {"not a whole page", whole.substr(0, 1000), ""},
      {"half of it", whole.substr(0, whole.size() / 2), "damaged"},
      {"all but a page", whole.substr(0, whole.size() - 4096), "damaged"},
      {"all but a byte", whole.substr(0, whole.size() - 1), "damaged"},
      {"zeros in the middle",
       whole.substr(0, 40960) + std::string(8192, '\0') + whole.substr(49152),
       "damaged"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      WriteBytes(path, row.bytes);
      const std::string failure = OpenFailure(path);
      CAPTURE(failure);
      CHECK(Contains(failure, path));
      CHECK(Contains(failure, row.message));
      CHECK(ReadBytes(path) == row.bytes);
      CHECK(scratch.Files() == std::vector<std::string>{"run"});
    }
  }
}

TEST_CASE("What cannot be opened says why", "[verify]") {
  const Scratch scratch;
  CHECK(OpenFailure(scratch / "none") ==
        "cannot open '" + (scratch / "none") + "': No such file or directory");
  std::filesystem::create_directory(scratch / "folder");
  CHECK(OpenFailure(scratch / "folder") ==
        "cannot open '" + (scratch / "folder") + "': it is a folder");
  REQUIRE(mkfifo((scratch / "pipe").c_str(), 0600) == 0);
  CHECK(OpenFailure(scratch / "pipe") ==
        "cannot open '" + (scratch / "pipe") + "': it is no file");
}

TEST_CASE("A journal that is missing or damaged costs what was in it at most",
          "[verify]") {
  const Scratch scratch;
  const std::string path = scratch / "run";
  const test::Recorder run = test::RecordRun(test::StoredExperiment());
  // A copy in the middle of the writing is what a kill leaves behind.
  std::string file, journal;
  {
    RunStore store;
    REQUIRE(store.Create(path, test::StoredExperiment()) == std::nullopt);
    REQUIRE(test::Report(run, store, 0, 3) == "");
    file = ReadBytes(path);
    journal = ReadBytes(path + "-wal");
  }
  REQUIRE(journal.size() > 100000);
  struct Row {
    const char* why;
    std::string journal;
    int most;
  };
  std::string flipped = journal;
  flipped[journal.size() / 2] = static_cast<char>(~flipped[journal.size() / 2]);
  const std::vector<Row> rows = {
      {"whole", journal, 3},
      {"missing", "", 0},
      {"cut", journal.substr(0, journal.size() / 3 * 2 + 17), 3},
      {"a byte of it wrong", flipped, 3},
      {"lost in a power cut", std::string(journal.size(), '\0'), 0},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const std::string copy = scratch / "copy";
      WriteBytes(copy, file);
      if (!row.journal.empty()) WriteBytes(copy + "-wal", row.journal);
      RunStore store;
      REQUIRE(store.Open(copy) == std::nullopt);
      auto saved = store.Load();
      REQUIRE(saved);
      CHECK(saved->generations <= row.most);
      if (std::string(row.why) == "whole") CHECK(saved->generations == 3);
      // What was lost is done again, and then all is as it was.
      for (std::size_t g = static_cast<std::size_t>(saved->generations);
           g < run.births.size(); ++g) {
        std::vector<Individual> born;
        for (const int id : run.births[g])
          born.push_back(run.individuals[static_cast<std::size_t>(id - 1)]);
        REQUIRE(store.OnBirths(born, {}) == std::nullopt);
        for (const Individual& one : born)
          if (!saved->evaluated.contains(one.id))
            REQUIRE(
                store.OnEvaluated(
                    one, run.evidence[static_cast<std::size_t>(one.id - 1)]) ==
                std::nullopt);
        REQUIRE(store.OnGeneration(run.generations[g]) == std::nullopt);
      }
      REQUIRE(store.Close() == std::nullopt);
      WriteRun(scratch / "straight");
      CHECK(*DumpResults(copy) == *DumpResults(scratch / "straight"));
    }
  }
}

}  // namespace plsc
