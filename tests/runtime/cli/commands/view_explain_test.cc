#include "runtime/cli/commands/view_explain.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "runtime/pages/page.h"
#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"

namespace plsc {
namespace {

using Json = nlohmann::json;
using test::RunPlsc;

Json DataOf(const std::string& page) {
  const std::string open = R"(<script type="application/json" id="data">)";
  const std::size_t begin = page.find(open) + open.size();
  return Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

Json Explain(std::vector<std::string> arguments) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "page.html";
  arguments.insert(arguments.begin(), {"view", "--explain"});
  arguments.insert(arguments.end(), {"-o", path});
  const auto ran = RunPlsc(arguments, test::kPlasticText);
  INFO(ran.err);
  REQUIRE(ran.exit == 0);
  CHECK(ran.err == "wrote " + path + "\n");
  return DataOf(test::ReadFile(path));
}

TEST_CASE("view --explain writes a page of all environments",
          "[view_explain]") {
  if (!HasPages()) return;
  const Json data = Explain({"-"});
  REQUIRE(data["robots"].size() == 1);
  const Json& robot = data["robots"][0];
  CHECK(robot["title"] == "plastic");
  CHECK(robot["text"] == test::kPlasticText);
  CHECK(robot["environments"].size() == 2);
  CHECK(Explain({"-", "--env", "tilted"})["robots"][0]["environments"].size() ==
        1);
}

TEST_CASE("view --explain takes several robots, also of runs",
          "[view_explain]") {
  if (!HasPages()) return;
  const std::string run = test::FinishedRun().path();
  const Json data =
      Explain({test::InRepository("examples/gecko.pls"), run, "3", "18", run});
  REQUIRE(data["robots"].size() == 4);
  CHECK(data["robots"][0]["file"] == "gecko.pls");
  CHECK(data["robots"][2]["title"] == "robot_18 of generation 2");
  CHECK(data["robots"][2]["environments"][1]["name"] == "hill");
  CHECK(data["robots"][2]["text"] ==
        RunPlsc({"show", run, "18", "--genotype"}).out);
}

TEST_CASE("view --explain says what is wrong, and leaves nothing behind",
          "[view_explain]") {
  if (!HasPages()) return;
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("robot.pls", test::kPlasticText);
  const std::string many = folder.Write("many.pls", R"(plsc 1
genotype many
alphabet plasticoding 1
iterations 15
rule C -> { C B B }
rule B -> { B B }
)");
  const std::string bomb = folder.Write("bomb.pls", R"(plsc 1
genotype bomb
alphabet plasticoding 1
iterations 30
rule C -> { C B B }
rule B -> { B B }
)");
  const std::string recording = folder.Write("robot.json", "{}");
  const std::string damaged =
      folder.Write("damaged.sqlite", "SQLite format 3 and no more");
  struct Row {
    const char* why;
    std::vector<std::string> arguments;
    int exit;
    const char* message;
  };
  const std::string page = folder / "page.html";
  const std::vector<Row> rows = {
      {"no file", {folder / "none.pls", "-o", page}, 1, "none.pls"},
      {"no such environment", {file, "--env", "x", "-o", page}, 2, "flat"},
      {"a recording", {recording, "-o", page}, 1, "is a recording"},
      {"a damaged store", {damaged, "-o", page}, 1, "damaged.sqlite"},
      {"no such robot",
       {test::FinishedRun().path(), "99", "-o", page},
       1,
       "99"},
      {"too many symbols", {many, "-o", page}, 1, "too many for a page"},
      {"a string that grows", {bomb, "-o", page}, 1, "P4001"},
      {"no bodies",
       {test::InRepository("examples/didactic.pls"), "-o", page},
       1,
       "no bodies"},
      {"no such folder", {file, "-o", folder / "no/p.html"}, 1, "cannot write"},
      {"no output", {file}, 2, "--output"},
      {"a scenario", {file, "--scenario", "x.yaml", "-o", page}, 2, "exclu"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      std::vector<std::string> arguments{"view", "--explain"};
      arguments.insert(arguments.end(), row.arguments.begin(),
                       row.arguments.end());
      const auto ran = RunPlsc(arguments);
      INFO(ran.err);
      CHECK(ran.exit == row.exit);
      CHECK(ran.err.find(row.message) != std::string::npos);
      CHECK_FALSE(std::filesystem::exists(page));
    }
  }
  const auto alone = RunPlsc({"view", file, "--env", "flat", "-o", page});
  CHECK(alone.exit == 2);
}

}  // namespace
}  // namespace plsc
