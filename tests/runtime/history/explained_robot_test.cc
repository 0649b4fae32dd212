#include "runtime/history/explained_robot.h"

#include <catch2/catch.hpp>

#include "runtime/develop/trace.h"

namespace plsc {
namespace {

constexpr const char* kShy =
    "plsc 1\nalphabet plasticoding 1\nsense inclined: bool\n"
    "environment flat { inclined = False }\n"
    "rule C -> { C add_front B }\n"
    "rule C -> if inclined = True then { C add_left B }\n";

Expected<ExplainedRobot, NotExplained> ExplainText(const std::string& text) {
  const Source source("shy.pls", text);
  const auto mapped = CompileWithMap(source);
  REQUIRE(mapped);
  std::vector<NamedEnvironment> environments = mapped->program.environments;
  environments.push_back({"inclined=True", {{1}}});
  return ExplainRobot("shy", source, *mapped, environments);
}

TEST_CASE("a robot is explained in each environment", "[explained_robot]") {
  const auto robot = ExplainText(kShy);
  REQUIRE(robot);
  CHECK(robot->title == "shy");
  REQUIRE(robot->environments.size() == 2);
  CHECK(robot->environments[0].name == "flat");
  CHECK(robot->environments[0].senses == "inclined=False");
  CHECK(robot->environments[1].senses.empty());  // its name says it
  CHECK(robot->environments[0].history.active.rules.size() == 1);
  CHECK(robot->environments[1].history.active.rules.size() == 2);
}

TEST_CASE("what is too much to show is said, with its environment",
          "[explained_robot]") {
  std::string many = "rule B -> if inclined = True then {";
  for (int i = 0; i < 200; ++i) many += " B";
  const auto shown = ExplainText(kShy + many + " }\n");
  REQUIRE_FALSE(shown);
  CHECK(shown.error().why == NotExplained::Why::kTooManyToShow);
  CHECK(shown.error().environment.name == "inclined=True");
  const auto grown = ExplainText(kShy + many + " }\niterations 6\n");
  REQUIRE_FALSE(grown);
  CHECK(grown.error().why == NotExplained::Why::kGrown);
  CHECK(TooManyToShow("shy") ==
        "the rewritings of shy have more than 20000 symbols, too many for a "
        "page");
}

}  // namespace
}  // namespace plsc
