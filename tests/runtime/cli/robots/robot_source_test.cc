#include "runtime/cli/robots/robot_source.h"

#include <catch2/catch.hpp>
#include <sstream>

#include "compiler/named_environments.h"
#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"

namespace plsc {
namespace {

TEST_CASE("a robot of a run has text, with the places of its rules",
          "[robot_source]") {
  std::istringstream in;
  std::ostringstream out;
  std::ostringstream err;
  cli::Io io{in, out, err};
  const std::string run = test::FinishedRun().path();
  const auto found = cli::FindRobot({run, "18", {}, false}, io);
  INFO(err.str());
  REQUIRE(found);
  const cli::RobotFound* robot = &*found;
  CHECK(robot->title == "robot_18 of generation 2");
  CHECK(std::string(robot->loaded.source.text()) ==
        test::RunPlsc({"show", run, "18", "--genotype"}).out);
  const MappedProgram& mapped = robot->loaded.mapped;
  CHECK(mapped.map.rules.size() == mapped.program.genotype.rules.size());
  REQUIRE(robot->environments.size() == 2);
  CHECK(robot->environments[1].name == "hill");
  CHECK(robot->environments[1].environment == Environment{{1}});
  CHECK(SensesOf(robot->environments[1], mapped.program.genotype.states) ==
        "inclined=True");
  CHECK(SensesOf({"inclined=True", Environment{{1}}},
                 mapped.program.genotype.states)
            .empty());
}

TEST_CASE("a robot of a file has its environments", "[robot_source]") {
  const test::TemporaryFolder folder;
  std::istringstream in;
  std::ostringstream out;
  std::ostringstream err;
  cli::Io io{in, out, err};
  const std::string file = folder.Write("robot.pls", test::kPlasticText);
  const auto found = cli::FindRobot({file, "", {}, false}, io);
  REQUIRE(found);
  const cli::RobotFound* robot = &*found;
  CHECK(robot->title == "plastic");
  CHECK(robot->environments.size() == 2);
}

}  // namespace
}  // namespace plsc
