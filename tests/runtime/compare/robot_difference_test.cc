#include "runtime/compare/robot_difference.h"

#include <catch2/catch.hpp>

#include "compiler/compile.h"

namespace plsc {
namespace {

Program CompiledRobot(const std::string& text) {
  const auto program = Compile(Source("text", "plsc 1\n" + text));
  REQUIRE(program);
  return *program;
}

std::vector<EnvironmentDifference> ComparedTexts(const std::string& before,
                                                 const std::string& after) {
  const Program old_program = CompiledRobot(before);
  const Program new_program = CompiledRobot(after);
  return CompareRobots(
      FindSharedEnvironments(old_program, new_program).environments,
      old_program.genotype, new_program.genotype);
}

const std::string kHead = "alphabet plasticoding 1\nsense a: bool\n";

TEST_CASE("Robots are compared in every environment", "[robot_difference]") {
  const auto compared = ComparedTexts(
      kHead + "rule C -> if a = True then { C add_left B }\n",
      kHead + "rule C -> if a = True then { C add_left T(0.5) }\n");
  REQUIRE(compared.size() == 2);
  CHECK(compared[0].differences.empty());
  CHECK(compared[1].differences.size() == 2);  // no brick, but a sensor
}

TEST_CASE("Strings that grow too long are no robots", "[robot_difference]") {
  const std::string grows =
      kHead + "iterations 100\nrule B -> { B B }\nrule C -> { C B }\n";
  CHECK(ComparedTexts(grows, grows)[0].differences.empty());
  CHECK(ComparedTexts(grows, kHead)[0].differences.size() == 1);
}

TEST_CASE("Of alphabets without bodies the strings are compared",
          "[robot_difference]") {
  const std::string head =
      "alphabet own { replaceable X; terminal y, z }\naxiom X\n";
  CHECK(ComparedTexts(head + "rule X -> { y }\n", head + "rule X -> { z }\n")[0]
            .differences.size() == 1);
  CHECK(ComparedTexts(head, head)[0].differences.empty());
  CHECK(ComparedTexts(head, kHead)[0].differences.size() == 1);
}

TEST_CASE("GroupAlike puts environments of equal differences together",
          "[robot_difference]") {
  const auto compared =
      ComparedTexts(kHead + "rule C -> if a = True then { C add_left B }\n",
                    kHead + "rule C -> if a = False then { C add_right B }\n");
  CHECK(GroupAlike(compared).size() == 2);
  const auto alike =
      ComparedTexts(kHead + "rule A1 -> if a = True then { B }\n", kHead);
  REQUIRE(GroupAlike(alike).size() == 1);
  CHECK(GroupAlike(alike)[0].size() == 2);
}

}  // namespace
}  // namespace plsc
