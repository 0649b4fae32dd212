#include "compiler/own_alphabet.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "compiler/compiled.h"

namespace plsc {
namespace {

using testing::CodesOf;
using testing::Compiled;

TEST_CASE("A file declares symbols with typed parameters", "[own_alphabet]") {
  const Program program = Compiled(
      "plsc 1 alphabet m { replaceable X, Y(n: int in 1..9, r: real);\n"
      "terminal a(angle: real in -180..180) replaceable Z } axiom X");
  const Alphabet& alphabet = *program.genotype.alphabet;
  CHECK(alphabet.name() == "m");
  CHECK_FALSE(alphabet.is_built_in());
  REQUIRE(alphabet.symbols().size() == 4);
  const SymbolInfo& y = alphabet.symbols()[1];
  CHECK(y.is_replaceable);
  REQUIRE(y.parameters.size() == 2);
  CHECK(y.parameters[0].is_integer);
  CHECK(y.parameters[0].high == 9);
  CHECK(y.parameters[0].sampling == Sampling::kUniform);
  CHECK(std::isinf(y.parameters[1].low));
  CHECK(y.parameters[1].sampling == Sampling::kNormal);
  CHECK_FALSE(alphabet.symbols()[2].is_replaceable);
  CHECK(alphabet.symbols()[2].category == Category::kTerminal);
  CHECK(alphabet.symbols()[3].is_replaceable);
}

TEST_CASE("Arguments of own symbols are checked like the built-in ones",
          "[own_alphabet]") {
  const std::string head =
      "plsc 1 alphabet m { replaceable X; terminal a(n: int in 1..9) } "
      "axiom X rule X -> { ";
  CHECK(CodesOf(head + "a(9) }").empty());
  CHECK(CodesOf(head + "a(10) }") == "P2004");
  CHECK(CodesOf(head + "a(1.5) }") == "P2003");
  CHECK(CodesOf(head + "a }") == "P2002");
  CHECK(CodesOf(head + "C }") == "P2001");
}

TEST_CASE("Own alphabets may use letters that mean more elsewhere",
          "[own_alphabet]") {
  // The core's place is Plasticoding's rule, not the language's.
  CHECK(CodesOf("plsc 1 alphabet m { replaceable C, B } axiom B "
                "rule B -> { C B C }")
            .empty());
}

}  // namespace
}  // namespace plsc
