#include "runtime/compare/same_robots.h"

#include <catch2/catch.hpp>

#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

const std::string kStates = "sense a: bool\nsense b: bool\niterations 1\n";

TEST_CASE("Robots are compared wherever clauses of either tell apart",
          "[same_robots]") {
  const Program before =
      test::CompileText("plsc 1\nalphabet plasticoding 1\n" + kStates +
                        "rule C -> if a = True then { C add_left B }\n"
                        "environment home { a = True, b = False }\n");
  const Genotype same =
      test::Robot(kStates + "rule C -> if a = True then { C B add_left B }\n");
  const auto equal = CompareRegimes(before.genotype, same, before.environments);
  REQUIRE(equal);
  CHECK(AreSame(*equal));
  REQUIRE(equal->size() == 2);
  CHECK((*equal)[0].where == "a = False");
  CHECK((*equal)[0].named.empty());
  CHECK((*equal)[1].named == std::vector<std::string>{"home"});

  // Only where a holds and b does not is there a difference.
  const Genotype other = test::Robot(
      kStates + "rule C -> if a = True and b = True then { C add_left B }\n");
  const auto compared = CompareRegimes(before.genotype, other, {});
  REQUIRE(compared);
  CHECK_FALSE(AreSame(*compared));
  REQUIRE(compared->size() == 3);
  CHECK((*compared)[0].count == 2);
  CHECK((*compared)[0].before == (*compared)[0].after);
  CHECK((*compared)[1].where == "a = True and b = False");
  CHECK((*compared)[1].before != (*compared)[1].after);
  CHECK((*compared)[2].before == (*compared)[2].after);
}

TEST_CASE("What cannot be developed is not compared", "[same_robots]") {
  const Genotype small = test::Robot("iterations 30\nrule C -> { C B }\n");
  const Genotype large =
      test::Robot("iterations 30\nrule C -> { C B }\nrule B -> { B B }\n");
  CHECK_FALSE(CompareRegimes(small, large, {}));
  CHECK(CompareRegimes(small, small, {}));
}

}  // namespace
}  // namespace plsc
