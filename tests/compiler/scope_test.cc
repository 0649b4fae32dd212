#include "compiler/scope.h"

#include <catch2/catch.hpp>
#include <string>

#include "compiler/compiled.h"
#include "grammar/parse.h"

namespace plsc {
namespace {

using testing::CodesOf;

TEST_CASE("The header of a file is read into a scope", "[scope]") {
  const Source source(
      "a",
      "plsc 1 genotype g alphabet plasticoding 1 sense hot: bool\n"
      "sense t: real in -40..60 sense ground: { dry, wet }\n"
      "let w = -0 let n = 3 axiom C iterations 0 max_modules 1000\n"
      "move_to_new True max_terms 2 max_rules 5");
  const ParseResult parsed = Parse(source);
  const Scope scope = Declare(parsed.file);
  REQUIRE(scope.diagnostics.empty());
  CHECK(scope.header.name == "g");
  CHECK(scope.header.development == DevelopmentSettings{0, 1000, true});
  CHECK(scope.header.max_terms == 2);
  CHECK(scope.header.max_rules == 5);
  REQUIRE(scope.header.states.size() == 3);
  CHECK(scope.FindState("t") == StateId{1});
  CHECK_FALSE(scope.FindState("T"));
  CHECK(scope.header.states[1].low == -40);
  CHECK(scope.header.states[2].values ==
        std::vector<std::string>{"dry", "wet"});
  REQUIRE(scope.FindConstant("w") != nullptr);
  CHECK(std::signbit(scope.FindConstant("w")->value));
  CHECK(scope.FindConstant("n")->is_integer);
  CHECK(scope.FindConstant("hot") == nullptr);
}

TEST_CASE("What is missing is not missed in a file that parsed in part",
          "[scope]") {
  CHECK(CodesOf("plsc 1\nrule B -> { B }") == "P2012");
  CHECK(CodesOf("plsc 1\nalphabt plasticoding 1\nrule B -> { B }") == "P1101");
  CHECK(CodesOf("plsc 1\nalphabet m { replaceable X }\naxium X") == "P1101");
}

TEST_CASE("Without a known alphabet symbols are not judged", "[scope]") {
  CHECK(CodesOf("plsc 1 alphabet nonsense 1 rule A -> { b c }") == "P2010");
}

}  // namespace
}  // namespace plsc
