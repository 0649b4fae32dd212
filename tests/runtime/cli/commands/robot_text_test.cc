#include "runtime/cli/commands/robot_text.h"

#include <catch2/catch.hpp>

#include "runtime/life/evaluation.h"
#include "runtime/scenario/scenario_profile.h"
#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

TEST_CASE("seasons are told with what the robot did and looked like",
          "[robot_text]") {
  Scenario scenario = PaperScenario();
  for (Season& season : scenario.seasons) season.duration = 1;
  Individual one;
  CHECK(cli::SeasonsText(one) == "not evaluated yet\n");
  one.genotype = test::Robot(
      "sense inclined: bool\niterations 1\n"
      "rule C -> if inclined = False then { C add_front B }\n"
      "rule C -> if inclined = True then { C }\n");
  one.evaluation = Evaluate(one.genotype, scenario);
  const std::string text = cli::SeasonsText(one);
  CHECK(text.find("season flat: speed ") == 0);
  CHECK(text.find("2 modules\n") != std::string::npos);
  CHECK(text.find("│ B 2 │") != std::string::npos);
  CHECK(text.find("1 modules\n") != std::string::npos);
  SeasonResult& tilted = one.evaluation.seasons[1];
  tilted.behaviour = {};
  tilted.outcome = Outcome::kUnstable;
  tilted.reason = "too fast";
  CHECK(cli::SeasonLine(tilted) == "season tilted: unstable: too fast");
}

}  // namespace
}  // namespace plsc
