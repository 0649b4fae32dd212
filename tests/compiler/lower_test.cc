#include "compiler/lower.h"

#include <catch2/catch.hpp>

#include "compiler/compiled.h"

namespace plsc {
namespace {

using testing::Compiled;

TEST_CASE("Clauses keep terms and connectives in file order", "[lower]") {
  const Genotype genotype = Compiled(
                                "plsc 1 alphabet plasticoding 1 sense a: bool "
                                "sense r: real in 0..9 rule B -> "
                                "if r > 3 or a = True and r <= 2.5 then { B }")
                                .genotype;
  const Clause& clause = genotype.rules[0].clause;
  REQUIRE(clause.terms.size() == 3);
  CHECK(clause.connectives ==
        std::vector<Connective>{Connective::kOr, Connective::kAnd});
  CHECK(clause.terms[0] == Term{StateId{1}, Comparison::kGreater, 3});
  CHECK(clause.terms[1] == Term{StateId{0}, Comparison::kEqual, 1});
  CHECK(clause.terms[2] == Term{StateId{1}, Comparison::kLessEqual, 2.5});
}

TEST_CASE("Environments have their values in the order of the states",
          "[lower]") {
  const Program program = Compiled(
      "plsc 1 alphabet plasticoding 1 sense a: bool sense e: { x, y, z } "
      "environment one { e = z, a = True }");
  REQUIRE(program.environments.size() == 1);
  CHECK(program.environments[0].name == "one");
  CHECK(program.environments[0].environment.values ==
        std::vector<double>{1, 2});
}

TEST_CASE("Unused places of arguments are plus zero", "[lower]") {
  const Genotype genotype =
      Compiled("plsc 1 alphabet plasticoding 1 rule B -> { T(-0) B }").genotype;
  const std::vector<Symbol>& production = genotype.rules[0].production;
  CHECK(production[0] == Symbol{plasticoding::kT, {-0.0, 0, 0, 0}});
  CHECK(production[1] == Symbol{plasticoding::kB, {}});
}

}  // namespace
}  // namespace plsc
