#include "runtime/advice/stats_text.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

const std::string kRenderedText =
    "plsc 1\ngenotype sample\nalphabet plasticoding 1\nsense wet: bool\n"
    "iterations 1\n"
    "rule C -> if wet = False then { C add_left B }\n"
    "rule C -> if wet = True then { C B add_left A2(0.5, 2, 3, 1) }\n"
    "environment dry { wet = False }\nenvironment rain { wet = True }\n";

TEST_CASE("Statistics are a column an environment", "[stats_text]") {
  const Program program = test::CompileText(kRenderedText);
  const auto stats = StatsOf(program.genotype, program.environments);
  REQUIRE(stats);
  CHECK(StatsText(program.genotype, *stats) ==
        R"(sample: 2 rules, 2 terms of clauses, 7 symbols
in some environment: 2 (100 %) rules active, 6 (86 %) symbols expressed
over 2 environments: 2 bodies, 2 brains

                          dry                            rain
active rules              1 (50 %)                       1 (50 %)
expressed symbols         3 (43 %)                       3 (43 %)
derived string            3                              4
  of it expressed         3 (100 %)                      3 (75 %)
modules                   2                              2
  joints                  0                              1
sensors                   0                              0
brain nodes               0                              1
brain edges               0                              0
body                      reference                      1 shared, 1 other, 0 new, 0 gone
brain                     reference                      another
rule 1: C if wet = False  1x, 3 of 3 symbols, 2 modules  -
rule 2: C if wet = True   -                              1x, 3 of 4 symbols, 2 modules
)");
}

TEST_CASE("Statistics as JSON have the same numbers", "[stats_text]") {
  const Program program = test::CompileText(kRenderedText);
  const auto stats = StatsOf(program.genotype, program.environments);
  const auto json =
      nlohmann::json::parse(StatsJson("a.pls", program.genotype, *stats));
  CHECK(json["file"] == "a.pls");
  CHECK(json["symbols"] == 7);
  CHECK(json["expressed"] == 6);
  CHECK(json["rules"][1]["clause"] == "wet = True");
  CHECK(json["environments"][1]["rules"][1]["expressed"] == 3);
  CHECK(json["environments"][1]["difference"]["other"] == 1);
  CHECK(json["environments"][1]["difference"]["brain"] == true);
}

}  // namespace
}  // namespace plsc
