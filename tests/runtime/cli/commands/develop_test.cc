#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using Json = nlohmann::json;
using test::kPlasticText;
using test::RunPlsc;

TEST_CASE("develop grows the robot of one environment", "[develop]") {
  for (const char* env : {"inclined=True", "tilted"}) {
    INFO(env);
    const auto ran = RunPlsc({"develop", "-", "--env", env, "--format", "json"},
                             kPlasticText);
    REQUIRE(ran.exit == 0);
    const Json robot = Json::parse(ran.out);
    CHECK(robot["genotype"] == "plastic");
    CHECK(robot["environment"] == Json{{"inclined", true}});
    CHECK(robot["active_rules"] == Json{2});
    CHECK(robot["early"].size() == 6);
    CHECK(robot["body"]["children"]["left"]["type"] == "A2");
    CHECK(robot["brain"]["nodes"][0]["period"] == 3.0);
    CHECK(robot["body_descriptors"]["absolute_size"] == 3);
  }
}

TEST_CASE("develop without --env grows every environment of the file",
          "[develop]") {
  const auto ran = RunPlsc({"develop", "-", "--format", "json"}, kPlasticText);
  REQUIRE(ran.exit == 0);
  CHECK(std::count(ran.out.begin(), ran.out.end(), '\n') == 2);
  const auto text = RunPlsc({"develop", "-"}, kPlasticText);
  REQUIRE(text.exit == 0);
  CHECK(text.out.find("plastic in flat (inclined=False): 1 of 2 rules "
                      "active, 3 symbols\n"
                      "┌─────┐\n"
                      "│ B 2 │\n"
                      "└──•──┘\n"
                      "┌─────┐\n"
                      "│ C 1 │\n"
                      "└─────┘\n") != std::string::npos);
}

TEST_CASE("develop says which environments it can use", "[develop]") {
  struct Row {
    const char* why;
    std::vector<std::string> env;
    const char* message;
  };
  const std::vector<Row> rows = {
      {"no such name", {"--env", "slope"}, "file names: flat tilted"},
      {"missing state", {"--env", ""}, "no value for state 'inclined'"},
      {"wrong type", {"--env", "inclined=1"}, "expected True or False"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      std::vector<std::string> arguments{"develop", "-"};
      arguments.insert(arguments.end(), row.env.begin(), row.env.end());
      const auto ran = RunPlsc(arguments, kPlasticText);
      CHECK(ran.exit == 2);
      CHECK(ran.out.empty());
      CHECK(ran.err.find(row.message) != std::string::npos);
    }
  }
}

TEST_CASE("develop asks for an environment when the file names none",
          "[develop]") {
  std::string text = kPlasticText;
  text.resize(text.find("environment flat"));
  const auto ran = RunPlsc({"develop", "-"}, text);
  CHECK(ran.exit == 2);
  CHECK(ran.err.find("add --env inclined=False") != std::string::npos);
}

TEST_CASE("develop warns of states that are not sensed, and goes on",
          "[develop]") {
  const auto ran = RunPlsc({"develop", "-", "--env", "inclined=True,hot=False"},
                           kPlasticText);
  CHECK(ran.exit == 0);
  CHECK(ran.err.find("does not sense 'hot'") != std::string::npos);
}

TEST_CASE("develop prints the paper's didactic derivation", "[develop]") {
  const auto ran =
      RunPlsc({"develop", test::InRepository("examples/didactic.pls")});
  REQUIRE(ran.exit == 0);
  CHECK(ran.out.find("Iteration 0: X\n"
                     "Iteration 1: X Y\n"
                     "Iteration 2: X Y Z a\n"
                     "Iteration 3: X Y Z a X Z a\n") != std::string::npos);
}

TEST_CASE("develop tells the whole story with --trace", "[develop]") {
  const auto text =
      RunPlsc({"develop", "-", "--env", "flat", "--trace"}, kPlasticText);
  REQUIRE(text.exit == 0);
  CHECK(text.out.find("\u2502 B 2 \u2502") != std::string::npos);
  CHECK(text.out.find("  not active rule 2 of C (if inclined = True), "
                      "<stdin>:") != std::string::npos);
  CHECK(text.out.find("  Iteration 0: C\n") != std::string::npos);
  CHECK(text.out.find("mounted as module 2 (B) at the front of module 1 (C) "
                      "by add_front (symbol 2)\n") != std::string::npos);

  const auto ran =
      RunPlsc({"develop", "-", "--env", "flat", "--trace", "--format", "json"},
              kPlasticText);
  REQUIRE(ran.exit == 0);
  Json robot = Json::parse(ran.out);
  CHECK(robot["trace"]["regulation"][1]["active"] == false);
  CHECK(robot["trace"]["derivation"]["steps"][0] == Json{1});
  CHECK(robot["trace"]["events"].size() == robot["early"].size());
  // Without it the same object is printed, but for the trace.
  robot.erase("trace");
  const auto plain = RunPlsc(
      {"develop", "-", "--env", "flat", "--format", "json"}, kPlasticText);
  CHECK(Json::parse(plain.out) == robot);
}

TEST_CASE("develop traces grammars without bodies", "[develop]") {
  const auto ran = RunPlsc(
      {"develop", "--trace", test::InRepository("examples/didactic.pls")});
  REQUIRE(ran.exit == 0);
  CHECK(ran.out.find("  active     rule 1 of X (always), ") !=
        std::string::npos);
  CHECK(ran.out.find("  Iteration 3: X Y Z a X Z a\n") != std::string::npos);
  CHECK(ran.out.find("\nIteration 3") == std::string::npos);
}

TEST_CASE("develop draws a body a file", "[develop]") {
  const test::TemporaryFolder folder;
  const auto ran =
      RunPlsc({"develop", "-", "--svg", folder / "pictures"}, kPlasticText);
  REQUIRE(ran.exit == 0);
  const std::string svg =
      test::ReadFile(folder.path() / "pictures" / "plastic-tilted.svg");
  CHECK(svg.find("plastic, tilted") != std::string::npos);
  CHECK(
      std::filesystem::exists(folder.path() / "pictures" / "plastic-flat.svg"));
}

TEST_CASE("develop says when a picture cannot be written", "[develop]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("file", "");
  const auto ran = RunPlsc({"develop", "-", "--svg", file}, kPlasticText);
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("cannot make the folder") != std::string::npos);
  const auto didactic =
      RunPlsc({"develop", test::InRepository("examples/didactic.pls"), "--svg",
               folder / "pictures"});
  CHECK(didactic.exit == 2);
  CHECK(folder.Files() == std::vector<std::string>{"file"});
}

TEST_CASE("develop stops before a string outgrows its limit", "[develop]") {
  const auto ran = RunPlsc({"develop", "-"}, R"(plsc 1
genotype bomb
alphabet plasticoding 1
iterations 30
rule C -> { C B B }
rule B -> { B B }
)");
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("P4001") != std::string::npos);
}

TEST_CASE("develop explains an unreadable or a wrong file", "[develop]") {
  const test::TemporaryFolder folder;
  CHECK(RunPlsc({"develop", folder / "none.pls"}).exit == 1);
  CHECK(RunPlsc({"develop", folder.path().string()}).exit == 1);
  const auto ran = RunPlsc({"develop", "-"}, "plsc 1\nrulle C -> { C }\n");
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("<stdin>:2:1") != std::string::npos);
}

}  // namespace
}  // namespace plsc
