#include "compiler/print.h"

#include <catch2/catch.hpp>

#include "compiler/compiled.h"

namespace plsc {
namespace {

using testing::Compiled;

TEST_CASE("The canonical text has all items in fixed order", "[print]") {
  const Program program = Compiled(
      "plsc 1 environment e { r = 1e0, a = True } rule B -> if a=True then "
      "{ B T(k) } rule C -> { C } max_rules 2 max_terms 9 let k = 0.50 "
      "sense a: bool sense r: real in -1..1e3 alphabet plasticoding 1 "
      "genotype g");
  CHECK(Print(program) == R"(plsc 1

genotype g
alphabet plasticoding 1
sense a: bool
sense r: real in -1..1000
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 9
max_rules 2

rule C -> {
  C
}

rule B -> if a = True then {
  B
  T(0.5)
}

environment e { a = True, r = 1 }
)");
}

TEST_CASE("Whole numbers print without an exponent", "[print]") {
  Symbol symbol;
  symbol.id = plasticoding::kMoveRefI;
  symbol.arguments = {1e15, 2};
  CHECK(PrintSymbol(symbol, *PlasticodingAlphabet()) ==
        "move_ref_I(1000000000000000, 2)");
}

TEST_CASE("Parts print as they are written", "[print]") {
  const Program program = Compiled(
      "plsc 1 alphabet plasticoding 1 sense a: bool sense e: { x, y } "
      "sense r: real in 0..9 rule B -> if a = True and e != y or r >= 0.5 "
      "then { A1(0.5, 1.0, 2.0, 3.25) } "
      "environment one { a = False, e = y, r = 3 }");
  const Genotype& genotype = program.genotype;
  CHECK(PrintClause(genotype.rules[0].clause, genotype) ==
        "a = True and e != y or r >= 0.5");
  CHECK(PrintSymbol(genotype.rules[0].production[0], *genotype.alphabet) ==
        "A1(0.5, 1, 2, 3.25)");
  CHECK(PrintEnvironment(program.environments[0].environment,
                         genotype.states) == "a=False,e=y,r=3");
  CHECK(PrintClause(Clause{}, genotype).empty());
}

TEST_CASE("A built-in alphabet prints its name and version", "[print]") {
  CHECK(PrintAlphabet(*PlasticodingAlphabet()) == "alphabet plasticoding 1\n");
}

TEST_CASE("An own alphabet prints in the order of its numbering", "[print]") {
  const Program program = testing::Compiled(
      "plsc 1 alphabet m { terminal a; replaceable X replaceable "
      "Y(n: int in -5..1000000000000000, r: real), Z(q: real in -0..1e9) "
      "terminal b } axiom X");
  CHECK(PrintAlphabet(*program.genotype.alphabet) ==
        "alphabet m {\n"
        "  terminal a;\n"
        "  replaceable X, Y(n: int in -5..1000000000000000, r: real), "
        "Z(q: real in -0..1e+09);\n"
        "  terminal b\n"
        "}\n");
}

}  // namespace
}  // namespace plsc
