#include "runtime/history/regulation_text.h"

#include <catch2/catch.hpp>

#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

constexpr const char* kText =
    "plsc 1\n"
    "alphabet own { replaceable X, Y(n: int); terminal a }\n"
    "axiom X\n"
    "sense wet: bool\n"
    "sense t: real in 0..10\n"
    "sense ground: { rock, sand, ice }\n"
    "rule Y -> if ground = ice then { a }\n"
    "rule X -> if wet = True then { X Y(2) }\n"
    "rule X -> if wet = True or t >= 5 then { a }\n"
    "environment sea { wet = True, t = 7, ground = sand }\n";

TEST_CASE("Tables mark gaps and joined rules", "[regulation]") {
  const Genotype genotype = test::CompileText(kText).genotype;
  CHECK(RegulationTable(genotype, StateSpace(genotype)) ==
        "wet    t      ground     X    Y\n"
        "False  0..<5  rock|sand  -    -\n"
        "False  0..<5  ice        -    3\n"
        "False  5..10  rock|sand  2    -\n"
        "False  5..10  ice        2    3\n"
        "True   0..<5  rock|sand  1+2  -\n"
        "True   0..<5  ice        1+2  3\n"
        "True   5..10  rock|sand  1+2  -\n"
        "True   5..10  ice        1+2  3\n");
}

TEST_CASE("Tables of genotypes that sense nothing have one row",
          "[regulation]") {
  const Genotype one = test::Didactic("rule X -> { a }\n");
  CHECK(RegulationTable(one, StateSpace(one)) == "X\n1\n");
  const Genotype none = test::Didactic("");
  CHECK(RegulationTable(none, StateSpace(none)) == "no rules\n");
}

TEST_CASE("In an environment, symbols show what they become", "[regulation]") {
  const Program program = test::CompileText(kText);
  CHECK(RegulationText(program.genotype, program.environments[0]) ==
        "unnamed in sea (wet=True,t=7,ground=sand): 2 of 3 rules active\n"
        "X  1+2  -> X Y(2) a\n"
        "Y  -    stays\n");
}

TEST_CASE("The legend names each rule's clause and line", "[regulation]") {
  const Source source("a", kText);
  const auto compiled = CompileWithMap(source);
  REQUIRE(compiled);
  CHECK(RuleLegend(*compiled, source) ==
        "1: X if wet = True (line 8)\n"
        "2: X if wet = True or t >= 5 (line 9)\n"
        "3: Y if ground = ice (line 7)\n");
}

}  // namespace
}  // namespace plsc
