#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"

namespace plsc {
namespace {

using Json = nlohmann::json;
using test::kPlasticText;
using test::RunPlsc;

constexpr const char* kWalker =
    "plsc 1\n"
    "genotype walker\n"
    "alphabet plasticoding 1\n"
    "sense inclined: bool\n"
    "iterations 2\n"
    "rule C -> { C B }\n"
    "rule B -> if inclined = True then { add_left A2(0.5, 2, 3, 1) }\n"
    "rule B -> { add_front T(0.5) mutate_edge(0.25) }\n"
    "environment flat { inclined = False }\n"
    "environment tilted { inclined = True }\n";

TEST_CASE("why goes from a part back to its places in the file", "[why]") {
  const auto ran = RunPlsc(
      {"why", "-", "--edge", "node2-node1", "--env", "tilted"}, kWalker);
  REQUIRE(ran.exit == 0);
  CHECK(
      ran.out ==
      "walker in tilted (inclined=True): edge node2-node1\n"
      "symbol 6 of 7, T: mounted as sensor 1s1 (T) at the front of module 1 "
      "(C) by add_front (symbol 5); made node2 and node2-node1\n"
      " --> <stdin>:8:23\n"
      "8 | rule B -> { add_front T(0.5) mutate_edge(0.25) }\n"
      "  |                       ^^^^^^ inserted in iteration 2 by rule 3 (B, "
      "always)\n"
      "in place of B\n"
      " --> <stdin>:6:15\n"
      "6 | rule C -> { C B }\n"
      "  |               ^ inserted in iteration 1 by rule 1 (C, always)\n"
      "in place of C, the axiom\n"
      "changed by symbol 7 of 7, mutate_edge: weight of node2-node1 from "
      "0.5 to 0.75\n"
      " --> <stdin>:8:30\n"
      "8 | rule B -> { add_front T(0.5) mutate_edge(0.25) }\n"
      "  |                              ^^^^^^^^^^^^^^^^^ inserted in "
      "iteration 2 by rule 3 (B, always)\n"
      "in place of B\n"
      " --> <stdin>:6:15\n"
      "6 | rule C -> { C B }\n"
      "  |               ^ inserted in iteration 1 by rule 1 (C, always)\n"
      "in place of C, the axiom\n\n");
}

TEST_CASE("why goes forward from a symbol in every environment", "[why]") {
  const auto ran = RunPlsc({"why", "<stdin>:7:48"}, kWalker);
  REQUIRE(ran.exit == 0);
  CHECK(RunPlsc({"why", "-:7:48"}, kWalker).out == ran.out);
  CHECK(ran.out ==
        "A2(0.5, 2, 3, 1) of rule 2 (B, if inclined = True)\n"
        " --> <stdin>:7:46\n"
        "7 | rule B -> if inclined = True then { add_left A2(0.5, 2, 3, 1) }\n"
        "  |                                              ^^^^^^^^^^^^^^^^\n"
        "walker in flat (inclined=False):\n"
        "  rule 2 (B, if inclined = True) is not active\n"
        "walker in tilted (inclined=True):\n"
        "  inserted in iteration 2 for B < C; symbol 4 of 7: mounted as module "
        "2 (A2) at the left of module 1 (C) by add_left (symbol 3); made "
        "node1\n");
}

TEST_CASE("why answers as one object an environment", "[why]") {
  const auto ran =
      RunPlsc({"why", "-", "--module", "2", "--format", "json"}, kWalker);
  REQUIRE(ran.exit == 0);
  const std::size_t end = ran.out.find('\n');
  const Json flat = Json::parse(ran.out.substr(0, end));
  CHECK(flat["environment"] == Json{{"inclined", false}});
  CHECK(flat["origin"] == nullptr);
  const Json tilted = Json::parse(ran.out.substr(end + 1));
  CHECK(tilted["module"] == "2");
  CHECK(tilted["origin"]["index"] == 4);
  CHECK(tilted["origin"]["ancestry"][0]["place"]["line"] == 7);
  CHECK(tilted["origin"]["ancestry"][0]["clause"] == "inclined = True");

  const auto symbol = RunPlsc(
      {"why", "<stdin>:8:13", "--env", "flat", "--format", "json"}, kWalker);
  REQUIRE(symbol.exit == 0);
  const Json forward = Json::parse(symbol.out);
  CHECK(forward["genotype"] == "walker");
  CHECK(forward["symbol"] == "add_front");
  CHECK(forward["occurrences"][0]["event"]["effect"] == "slot_used");
}

TEST_CASE("why says which parts there are", "[why]") {
  const auto some = RunPlsc({"why", "-", "--module", "2"}, kWalker);
  CHECK(some.exit == 0);
  CHECK(some.out.find("walker in flat (inclined=False): no module 2; there is "
                      "1, 1s1\n") != std::string::npos);
  const auto none = RunPlsc({"why", "-", "--node", "7"}, kWalker);
  CHECK(none.exit == 1);
  CHECK(none.out.find("no node 7; there is node1, node2") != std::string::npos);
}

TEST_CASE("why explains a wrong question", "[why]") {
  struct Row {
    const char* why;
    std::vector<std::string> arguments;
    int exit;
    const char* message;
  };
  const std::vector<Row> rows = {
      {"nothing asked", {"-"}, 2, "ask for one of"},
      {"two questions", {"<stdin>:6:13", "--module", "1"}, 2, "ask for one of"},
      {"two parts", {"-", "--module", "1", "--node", "1"}, 2, "exclude"},
      {"no symbol there",
       {"<stdin>:6:1"},
       2,
       "no symbol of a production is here"},
      {"no such line", {"<stdin>:99:1"}, 2, "no line 99"},
      {"no such environment", {"<stdin>:6:13", "--env", "x"}, 2, "flat tilted"},
      {"no such file", {"none.pls:6:13"}, 1, "cannot read 'none.pls'"},
      {"no place but a name", {"none.pls:x"}, 2, "ask for one of"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      std::vector<std::string> arguments{"why"};
      arguments.insert(arguments.end(), row.arguments.begin(),
                       row.arguments.end());
      const auto ran = RunPlsc(arguments, kWalker);
      CHECK(ran.exit == row.exit);
      CHECK(ran.out.empty());
      CHECK(ran.err.find(row.message) != std::string::npos);
    }
  }
}

TEST_CASE("why follows symbols of other alphabets, which have no parts",
          "[why]") {
  const std::string file = test::InRepository("examples/didactic.pls");
  const std::string text = test::ReadFile(file);
  const std::size_t first =
      text.find_first_not_of(" \n", text.find('{', text.find("rule Y")) + 1);
  const auto line =
      1 + std::count(text.begin(),
                     text.begin() + static_cast<std::ptrdiff_t>(first), '\n');
  const std::size_t column = first - text.rfind('\n', first);
  const auto ran =
      RunPlsc({"why", fmt::format("{}:{}:{}", file, line, column)});
  REQUIRE(ran.exit == 0);
  // X / X Y / X Y Z a / X Y Z a X Z a
  CHECK(ran.out.find("  inserted in iteration 2 for Y < X; replaced in "
                     "iteration 3\n") != std::string::npos);
  CHECK(ran.out.find("  inserted in iteration 3 for Y < X < X; symbol 3 of "
                     "7\n") != std::string::npos);
  CHECK(RunPlsc({"why", file, "--module", "1"}).exit == 2);
}

TEST_CASE("why asks about robots of runs, in the seasons they lived in",
          "[why]") {
  const std::string run = test::FinishedRun().path();
  const auto ran = RunPlsc({"why", run, "18", "--module", "1"});
  INFO(ran.err);
  CHECK(ran.exit == 0);
  CHECK(ran.out.find("robot_18 in flat (inclined=False): module 1") == 0);
  CHECK(ran.out.find("robot_18 in hill (inclined=True): module 1") !=
        std::string::npos);
  // Lines are those of `show --genotype`.
  const std::string text = RunPlsc({"show", run, "18", "--genotype"}).out;
  const std::string before = text.substr(0, text.find("  C\n"));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  CHECK(RunPlsc({"why", run + ":" + std::to_string(line) + ":3", "18"}).exit ==
        0);
  const auto nobody = RunPlsc({"why", run, "--module", "1"});
  CHECK(nobody.exit == 2);
  CHECK(nobody.err.find("which of its robots?") != std::string::npos);
}

TEST_CASE("why stops before a string outgrows its limit", "[why]") {
  const auto ran = RunPlsc({"why", "-", "--module", "1"},
                           "plsc 1 alphabet plasticoding 1 iterations 30\n"
                           "rule C -> { C B B }\nrule B -> { B B }\n");
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("P4001") != std::string::npos);
}

}  // namespace
}  // namespace plsc
