// docs/runs.md keeps its word: its queries run on a real store and find
// something, its Python runs (with pandas) or at least compiles and asks for
// what there is, and its tables name every table.

#include <catch2/catch.hpp>
#include <cstdlib>
#include <regex>
#include <string>
#include <vector>

#include "compiler/print.h"
#include "runtime/store/database.h"
#include "runtime/store/schema.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {

namespace {

std::string Document() {
  return test::ReadBytes(PLSC_SOURCE_DIR "/docs/runs.md");
}

/// Between ```KIND and ```.
std::vector<std::string> Blocks(const std::string& kind) {
  const std::string text = Document();
  const std::string begin = "```" + kind + "\n";
  std::vector<std::string> blocks;
  for (std::size_t at = text.find(begin); at != std::string::npos;
       at = text.find(begin, at)) {
    at += begin.size();
    blocks.push_back(text.substr(at, text.find("```", at) - at));
  }
  return blocks;
}

/// Whether a query is right, and how many rows it finds.
int CountRows(const std::string& path, const std::string& sql) {
  Database database;
  REQUIRE(database.Open(path, Database::Mode::kRead) == std::nullopt);
  Statement rows(database, sql);
  int count = 0;
  for (rows.With(); rows.Next();) ++count;
  CHECK(database.TakeFailure() == std::nullopt);
  return count;
}

}  // namespace

TEST_CASE("The eleven queries of docs/runs.md find something",
          "[runs_document]") {
  const test::Scratch scratch;
  test::WriteRun(scratch / "run1.sqlite");
  const std::vector<std::string> queries = Blocks("sql");
  CHECK(queries.size() == 11);
  for (const std::string& query : queries) {
    CAPTURE(query);
    CHECK(CountRows(scratch / "run1.sqlite", query) > 0);
  }
}

TEST_CASE("The pandas of docs/runs.md runs, or could", "[runs_document]") {
  const test::Scratch scratch;
  test::WriteRun(scratch / "run1.sqlite");
  const std::vector<std::string> blocks = Blocks("python");
  REQUIRE(blocks.size() == 1);
  CHECK(std::count(blocks[0].begin(), blocks[0].end(), '\n') == 10);
  test::WriteBytes(scratch / "block.py", blocks[0]);
  const std::regex query("read_sql\\(\"([^\"]*)\"");
  int queries = 0;
  for (std::sregex_iterator it(blocks[0].begin(), blocks[0].end(), query), end;
       it != end; ++it, ++queries)
    CHECK(CountRows(scratch / "run1.sqlite", (*it)[1]) > 0);
  CHECK(queries == 2);
  const auto run = [&](const std::string& python) {
    const std::string command = "cd '" + scratch.path().string() +
                                "' && python3 " + python +
                                " > printed 2> errors";
    return std::system(command.c_str()) == 0;
  };
  const bool is_compiled =
      run("-c 'import ast; "
          "ast.parse(open(\"block.py\").read())'");
  CAPTURE(test::ReadBytes(scratch / "errors"));
  CHECK(is_compiled);
  if (!run("-c 'import pandas'")) return;
  const bool is_run = run("block.py");
  CAPTURE(test::ReadBytes(scratch / "errors"));
  CHECK(is_run);
  CHECK(test::ReadBytes(scratch / "printed").size() > 100);
}

TEST_CASE("docs/runs.md names every table and view", "[runs_document]") {
  const std::string text = Document();
  for (const SchemaItem& item : Schema()) {
    CAPTURE(item.name);
    if (item.kind == SchemaKind::kIndex) continue;
    CHECK((text.find("| `" + item.name + "` |") != std::string::npos ||
           text.find("| `" + item.name + "(") != std::string::npos ||
           (!item.is_result && text.find("`" + item.name + "` is no result") !=
                                   std::string::npos)));
  }
}

TEST_CASE("Python's sqlite3 opens a store and has whole genotypes",
          "[runs_document]") {
  const test::Scratch scratch;
  test::WriteRun(scratch / "run", 2);
  test::WriteBytes(scratch / "look.py",
                   "import sqlite3\n"
                   "run = sqlite3.connect('run')\n"
                   "for text, in run.execute('SELECT text FROM genotype'):\n"
                   "    print(text, end='')\n");
  const std::string command =
      "cd '" + scratch.path().string() + "' && python3 look.py > texts";
  REQUIRE(std::system(command.c_str()) == 0);
  const test::Recorder run = test::RecordRun(test::StoredExperiment());
  std::string texts;
  for (int id = 1; id <= 20; ++id)
    texts += Print(run.individuals[static_cast<std::size_t>(id - 1)].genotype);
  CHECK(test::ReadBytes(scratch / "texts") == texts);
}

}  // namespace plsc
