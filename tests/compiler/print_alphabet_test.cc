#include "compiler/print_alphabet.h"

#include <catch2/catch.hpp>

#include "compiler/compiled.h"

namespace plsc {
namespace {

TEST_CASE("A built-in alphabet prints its name and version",
          "[print_alphabet]") {
  CHECK(PrintAlphabet(*PlasticodingAlphabet()) == "alphabet plasticoding 1\n");
}

TEST_CASE("An own alphabet prints in the order of its numbering",
          "[print_alphabet]") {
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
