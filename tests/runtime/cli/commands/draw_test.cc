#include <catch2/catch.hpp>

#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"
#include "tests/runtime/pictures/count.h"

namespace plsc {
namespace {

using test::Count;
using test::kPlasticText;
using test::ReadFile;
using test::RunPlsc;

TEST_CASE("draw shows all environments in the terminal", "[draw]") {
  const auto ran = RunPlsc({"draw", "-"}, kPlasticText);
  REQUIRE(ran.exit == 0);
  CHECK(ran.out ==
        "plastic\n\n"
        "flat             tilted\n"
        "inclined=False   inclined=True\n"
        "┌─────┐                        ┌╌╌╌╌╌┐\n"
        "│ B 2 │                        ╎     ╎\n"
        "└──•──┘                        └╌╌╌╌╌┘\n"
        "┌─────┐          ┏━━━━━┓┏━━━━━┓┌─────┐\n"
        "│ C 1 │          ┃ B 3 •┃A2 2 •│ C 1 │\n"
        "└─────┘          ┗━━━━━┛┗━━━━━┛└─────┘\n"
        "\n"
        "━ not there in flat, ╌ t there in flat only\n");
}

TEST_CASE("draw tells in the terminal which rule made what", "[draw]") {
  const auto ran = RunPlsc({"draw", "-", "--env", "tilted", "--colour", "rule"},
                           kPlasticText);
  REQUIRE(ran.exit == 0);
  CHECK(ran.out.find("rule 2: C, if inclined = True (line ") !=
        std::string::npos);
  CHECK(ran.out.find("): 1 2 3\n") != std::string::npos);
}

TEST_CASE("draw shows brains in the terminal", "[draw]") {
  const auto ran =
      RunPlsc({"draw", "-", "--env", "inclined=True", "--brain"}, kPlasticText);
  REQUIRE(ran.exit == 0);
  CHECK(ran.out.find("( node1 ) → A2 2 ") != std::string::npos);
}

TEST_CASE("draw tells how brains differ", "[draw]") {
  const auto ran = RunPlsc({"draw", "-", "--brain"}, kPlasticText);
  REQUIRE(ran.exit == 0);
  CHECK(ran.out.find("━ ( node1 ) → A2 2 ") != std::string::npos);
  CHECK(ran.out.ends_with("\n━ not there in flat\n"));
}

TEST_CASE("draw prints a picture", "[draw]") {
  const test::TemporaryFolder folder;
  const std::string path = folder / "robot.svg";
  REQUIRE(RunPlsc({"draw", "-", "-o", path}, kPlasticText).exit == 0);
  const auto printed = RunPlsc({"draw", "-", "-o", "-"}, kPlasticText);
  CHECK(printed.exit == 0);
  CHECK(printed.out == ReadFile(path));
  CHECK(printed.err.empty());
  const auto both =
      RunPlsc({"draw", "-", "-o", "-", "--terminal"}, kPlasticText);
  CHECK(both.exit == 2);
  CHECK(both.out.empty());
}

TEST_CASE("draw writes one picture of all environments", "[draw]") {
  const test::TemporaryFolder folder;
  const std::string path = folder / "robot.svg";
  const auto ran = RunPlsc({"draw", "-", "-o", path}, kPlasticText);
  REQUIRE(ran.exit == 0);
  CHECK(ran.out.empty());
  CHECK(ran.err == "wrote " + path + "\n");
  const std::string svg = ReadFile(path);
  CHECK(Count(svg, R"(class="panel")") == 2);
  CHECK(Count(svg, ">inclined=True<") == 1);
  // It is replaced, and the terminal gets its drawing when it is asked for.
  const auto again =
      RunPlsc({"draw", "-", "-o", path, "--terminal", "--colour", "rule"},
              kPlasticText);
  REQUIRE(again.exit == 0);
  CHECK(again.out.find("│ C 1 │") != std::string::npos);
  CHECK(Count(ReadFile(path), ">rule 2: C, if inclined = True (line ") == 1);
  const auto brain =
      RunPlsc({"draw", "-", "-o", path, "--brain"}, kPlasticText);
  REQUIRE(brain.exit == 0);
  CHECK(Count(ReadFile(path), R"(class="node")") == 1);
}

TEST_CASE("draw shows a robot of a run in its seasons", "[draw]") {
  const test::TinyRun& run = test::FinishedRun();
  const test::TemporaryFolder folder;
  for (const char* id : {"best", "18"}) {
    const std::string path = folder / (std::string(id) + ".svg");
    REQUIRE(RunPlsc({"draw", run.path(), id, "-o", path}).exit == 0);
    const std::string svg = ReadFile(path);
    CHECK(Count(svg, R"(class="panel")") == 2);
    CHECK(Count(svg, ">hill<") == 1);
    CHECK(Count(svg, " of generation ") == 2);
  }
  const auto one = RunPlsc({"draw", run.path(), "18", "--env", "hill"});
  CHECK(one.exit == 0);
  CHECK(one.out.find("flat") == std::string::npos);
}

TEST_CASE("draw says what is wrong, and leaves nothing behind", "[draw]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("robot.pls", kPlasticText);
  const std::string run = test::FinishedRun().path();
  const std::string damaged =
      folder.Write("damaged.sqlite", "SQLite format 3 and no more");
  const std::string bomb = folder.Write("bomb.pls", R"(plsc 1
genotype bomb
alphabet plasticoding 1
iterations 30
rule C -> { C B B }
rule B -> { B B }
)");
  struct Row {
    const char* why;
    std::vector<std::string> arguments;
    int exit;
    const char* message;
  };
  const std::vector<Row> rows = {
      {"no file", {folder / "none.pls"}, 1, "none.pls"},
      {"no such environment", {file, "--env", "slope"}, 2, "file names: flat"},
      {"another ending", {file, "-o", folder / "x.gif"}, 2, ".svg or .png"},
      {"no such folder", {file, "-o", folder / "no/x.svg"}, 1, "cannot write"},
      {"a scale of nothing", {file, "--scale", "2"}, 2, "--output"},
      {"a scale of 0", {file, "-o", folder / "x.png", "--scale", "0"}, 2, ""},
      {"no such colour", {file, "--colour", "size"}, 2, "size"},
      {"brains by rule", {file, "--brain", "--colour", "rule"}, 2, "exclu"},
      {"a run without a robot", {run}, 2, "add a number, or best"},
      {"no such robot", {run, "99"}, 1, "99"},
      {"no number", {run, "x"}, 1, "or best"},
      {"a damaged store", {damaged, "best"}, 1, "damaged.sqlite"},
      {"a robot of no run", {file, "1"}, 1, "robot.pls"},
      {"a string that grows", {bomb}, 1, "P4001"},
      {"no bodies",
       {test::InRepository("examples/didactic.pls")},
       1,
       "no bodies"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      std::vector<std::string> arguments{"draw"};
      arguments.insert(arguments.end(), row.arguments.begin(),
                       row.arguments.end());
      const auto ran = RunPlsc(arguments);
      CHECK(ran.exit == row.exit);
      CHECK(ran.out.empty());
      INFO(ran.err);
      CHECK(ran.err.find(row.message) != std::string::npos);
    }
  }
  CHECK(folder.Files() ==
        std::vector<std::string>{"bomb.pls", "damaged.sqlite", "robot.pls"});
}

}  // namespace
}  // namespace plsc
