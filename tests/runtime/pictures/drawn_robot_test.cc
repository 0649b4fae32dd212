#include "runtime/pictures/drawn_robot.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("a robot is drawn with the rules that made its modules",
          "[drawn_robot]") {
  const Source source("two.pls",
                      "plsc 1\nalphabet plasticoding 1\nsense wet: bool\n"
                      "rule C -> { C add_front B }\n"
                      "rule C -> if wet = True then { C add_left B }\n");
  const auto mapped = CompileWithMap(source);
  REQUIRE(mapped);
  const Genotype& genotype = mapped->program.genotype;
  DrawnRobot drawn;
  for (const NamedEnvironment& named :
       {NamedEnvironment{"dry", {{0}}}, NamedEnvironment{"wet=True", {{1}}}}) {
    const auto history = DevelopWithHistory(genotype, named.environment);
    REQUIRE(history);
    drawn.Add(named, *history, genotype.states);
  }
  REQUIRE(drawn.bodies.size() == 2);
  REQUIRE(drawn.brains.size() == 2);
  CHECK(drawn.bodies[0].senses == "wet=False");
  CHECK(drawn.brains[1].senses.empty());
  CHECK(drawn.bodies[0].rules.size() == 2);
  CHECK(drawn.bodies[1].rules.size() == 3);
  // The core is the axiom's, or of the rule that wrote it again.
  CHECK(drawn.bodies[1].rules[1] != drawn.bodies[1].rules[2]);
  CHECK(RuleTexts(source, *mapped) ==
        std::vector<std::string>{"rule 1: C, always (line 4)",
                                 "rule 2: C, if wet = True (line 5)"});
}

}  // namespace
}  // namespace plsc
