#include "runtime/advice/genotype_stats.h"

#include <catch2/catch.hpp>

#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

const std::string kStatsText =
    "plsc 1\ngenotype sample\nalphabet plasticoding 1\nsense wet: bool\n"
    "iterations 2\n"
    "rule C -> if wet = False then { C add_left B }\n"
    "rule C -> if wet = True then { C B add_left A2(0.5, 2, 3, 1) }\n"
    "rule B -> { add_front T(0.5) T(0.5) B }\n"
    "environment dry { wet = False }\nenvironment wet { wet = True }\n";

TEST_CASE("Statistics count what each rule did", "[genotype_stats]") {
  const Program program = test::CompileText(kStatsText);
  const auto result = StatsOf(program.genotype, program.environments);
  REQUIRE(result);
  const GenotypeStats& stats = *result;
  CHECK(stats.rules == 3);
  CHECK(stats.terms == 2);
  CHECK(stats.symbols == 11);
  CHECK(stats.active == 3);

  // C add_left B, then C add_left B add_left [add_front T T B]: the newest B
  // has no slot but add_left's, the sensors the front.
  const EnvironmentStats& dry = stats.environments[0];
  CHECK(dry.name == "dry");
  CHECK(dry.length == 8);
  CHECK(dry.rules[0].is_active);
  CHECK(dry.rules[0].applied == 2);
  CHECK_FALSE(dry.rules[1].is_active);
  CHECK(dry.rules[1].applied == 0);
  CHECK(dry.rules[2].applied == 1);
  CHECK(dry.has_body);
  std::size_t by_rules = 0;
  for (const RuleUsage& usage : dry.rules) by_rules += usage.modules;
  CHECK(by_rules == dry.modules + dry.sensors);
  CHECK(dry.difference.shared == dry.modules + dry.sensors);
  CHECK_FALSE(dry.difference.other_brain);

  const EnvironmentStats& wet = stats.environments[1];
  CHECK(wet.joints == 1);
  CHECK(wet.nodes == wet.joints + wet.sensors);
  CHECK(wet.difference.shared + wet.difference.other + wet.difference.added ==
        wet.modules + wet.sensors);
  CHECK(wet.difference.shared + wet.difference.other + wet.difference.missing ==
        dry.modules + dry.sensors);
  CHECK(wet.difference.other_brain);
  CHECK(stats.bodies == 2);
  CHECK(stats.brains == 2);
  CHECK(stats.expressed >= std::max(dry.expressed, wet.expressed));
  CHECK(stats.expressed < stats.symbols);
}

TEST_CASE("A robot that is the same everywhere is not plastic",
          "[genotype_stats]") {
  const Program program = test::CompileText(
      "plsc 1\nalphabet plasticoding 1\nsense wet: bool\n"
      "rule C -> { C add_left T(1) }\n"
      "environment a { wet = True }\nenvironment b { wet = False }\n");
  const auto stats = StatsOf(program.genotype, program.environments);
  CHECK(stats->bodies == 1);
  CHECK(stats->brains == 1);
}

TEST_CASE("Statistics of an own alphabet know no body", "[genotype_stats]") {
  const Genotype genotype =
      test::Didactic("iterations 2\nrule X -> { X Y a }\nrule Z -> { a }\n");
  const auto stats = StatsOf(genotype, {{"any", {}}});
  REQUIRE(stats);
  CHECK(stats->bodies == 0);
  CHECK(stats->environments[0].length == 5);
  CHECK(stats->environments[0].string_expressed == 5);
  CHECK(stats->symbols == 4);
  CHECK(stats->expressed == 3);
}

TEST_CASE("Statistics name the environment that outgrows its limit",
          "[genotype_stats]") {
  const Program program = test::CompileText(
      "plsc 1\nalphabet plasticoding 1\nsense wet: bool\niterations 30\n"
      "rule C -> { C B }\nrule B -> if wet = True then { B B }\n"
      "environment dry { wet = False }\nenvironment wet { wet = True }\n");
  const auto result = StatsOf(program.genotype, program.environments);
  CHECK_FALSE(result);
  CHECK(result.error().environment == 1);
}

}  // namespace
}  // namespace plsc
