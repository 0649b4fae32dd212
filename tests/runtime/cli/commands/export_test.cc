#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"

namespace plsc {
namespace {

using Json = nlohmann::json;
using test::ReadFile;
using test::RunPlsc;
using test::TemporaryFolder;

const std::vector<std::string> kTables = {
    "constants.csv", "generations.csv", "individuals.csv", "members.csv",
    "results.csv",   "robots.csv",      "run.csv",         "trials.csv"};

TEST_CASE("export writes a table a file", "[export]") {
  const test::TinyRun& run = test::FinishedRun();
  const TemporaryFolder folder;
  const auto exported =
      RunPlsc({"export", run.path(), "--csv", folder / "tables"});
  CHECK(exported.exit == 0);
  CHECK(exported.out.empty());
  CHECK(exported.err.empty());
  std::vector<std::string> files;
  for (const std::string& table : kTables)
    if (std::filesystem::exists(folder / ("tables/" + table)))
      files.push_back(table);
  CHECK(files == kTables);
  const std::string members = ReadFile(folder / "tables/members.csv");
  CHECK(members.find("generation,place,individual,count,survivor\r\n") == 0);
}

TEST_CASE("export writes an object a line", "[export]") {
  const test::TinyRun& run = test::FinishedRun();
  const auto exported = RunPlsc({"export", run.path(), "--jsonl"});
  CHECK(exported.exit == 0);
  std::istringstream lines(exported.out);
  int individuals = 0, generations = 0, runs = 0;
  for (std::string line; std::getline(lines, line);) {
    const Json object = Json::parse(line);
    runs += object.contains("run") ? 1 : 0;
    generations += object.contains("generation") ? 1 : 0;
    if (!object.contains("individual")) continue;
    CHECK(object["individual"]["id"] == ++individuals);
    CHECK(object["individual"]["seasons"].size() == 2);
  }
  CHECK(runs == 1);
  CHECK(individuals == 18);
  CHECK(generations == 3);
  const TemporaryFolder folder;
  const std::string file = folder / "run.jsonl";
  CHECK(RunPlsc({"export", run.path(), "--jsonl", "-o", file}).exit == 0);
  CHECK(ReadFile(file) == exported.out);
  CHECK(folder.Files() == std::vector<std::string>{"run.jsonl"});
}

TEST_CASE("export overwrites nothing without being told so", "[export]") {
  const test::TinyRun& run = test::FinishedRun();
  const TemporaryFolder folder;
  const std::string file = folder.Write("run.jsonl", "mine");
  const std::vector<std::string> lines = {"export", run.path(), "--jsonl", "-o",
                                          file};
  const auto refused = RunPlsc(lines);
  CHECK(refused.exit == 1);
  CHECK(refused.err == "error: cannot write '" + file +
                           "': it is no list of a run that plsc made; --force "
                           "replaces it\n");
  CHECK(ReadFile(file) == "mine");
  auto forced = lines;
  forced.emplace_back("--force");
  CHECK(RunPlsc(forced).exit == 0);
  CHECK(ReadFile(file) != "mine");

  std::filesystem::create_directory(folder / "tables");
  const std::string table = folder.Write("tables/results.csv", "mine");
  CHECK(RunPlsc({"export", run.path(), "--csv", folder / "tables"}).exit == 1);
  CHECK(ReadFile(table) == "mine");
  CHECK_FALSE(std::filesystem::exists(folder / "tables/run.csv"));
  CHECK(RunPlsc({"export", run.path(), "--csv", folder / "tables", "--force"})
            .exit == 0);
  CHECK(ReadFile(table) != "mine");
}

TEST_CASE("export says what is wrong", "[export]") {
  const test::TinyRun& run = test::FinishedRun();
  const TemporaryFolder folder;
  struct Row {
    const char* why;
    std::vector<std::string> arguments;
    int exit;
    const char* message;
  };
  const std::vector<Row> rows = {
      {"no format", {run.path()}, 2, "export as what?"},
      {"two formats",
       {run.path(), "--csv", folder / "a", "--jsonl"},
       2,
       "--jsonl"},
      {"a file for tables", {run.path(), "-o", folder / "a"}, 2, "--jsonl"},
      {"no file", {folder / "none", "--jsonl"}, 1, "No such file"},
      {"no run",
       {folder.Write("text", "text"), "--csv", folder / "a"},
       1,
       "is no SQLite file"},
      {"no folder to write to",
       {run.path(), "--jsonl", "-o", folder / "none/a"},
       1,
       "its folder does not exist"},
      {"a file for a folder",
       {run.path(), "--csv", folder.Write("file", "text")},
       1,
       "cannot"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      std::vector<std::string> arguments = {"export"};
      arguments.insert(arguments.end(), row.arguments.begin(),
                       row.arguments.end());
      const auto ran = RunPlsc(arguments);
      CHECK(ran.exit == row.exit);
      CAPTURE(ran.err);
      CHECK(ran.err.find(row.message) != std::string::npos);
      CHECK(ran.out.empty());
      CHECK_FALSE(std::filesystem::exists(folder / "a"));
    }
  }
}

}  // namespace
}  // namespace plsc
