#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "runtime/authors/genotype.h"

namespace plsc {
namespace {

std::string ErrorOf(const std::string& text) {
  const Source source("test", text);
  const AuthorsText read = ReadAuthorsRepr(source);
  if (read.problems.empty()) return "";
  return fmt::format("{}: {}", read.problems[0].span.begin,
                     read.problems[0].message);
}

TEST_CASE("The dictionary is read letter by letter", "[authors_repr]") {
  const Source source(
      "test",
      "{<Alphabet.CORE_COMPONENT: 'C'>: [[<Alphabet.CORE_COMPONENT: 'C'>, []], "
      "[<Alphabet.MOVE_REF_S: 'brainmoveFTS'>, [1, 2]]],\n"
      "<Alphabet.BLOCK: 'B'> : [[[['hot', '==', True], ['and'], ['hill', '==', "
      "False]], [[<Alphabet.BLOCK: 'B'>, []]]]]}\n");
  const AuthorsText read = ReadAuthorsRepr(source);
  CHECK(read.problems.empty());
  CHECK(read.has_clauses);
  CHECK(read.states == std::vector<std::string>{"hot", "hill"});
  REQUIRE(read.rules.size() == 2);
  CHECK(read.rules[0].symbols[1].token == "brainmoveFTS");
  REQUIRE(read.rules[0].symbols[1].parameters.size() == 2);
  CHECK(read.rules[0].symbols[1].parameters[1].value == 2);
  CHECK(read.rules[1].letter.token == "B");
  CHECK(read.rules[1].clause.terms.size() == 2);
  CHECK(read.rules[1].clause.terms[1].state == StateId{1});
  CHECK(read.rules[1].clause.terms[1].value == 0);
}

TEST_CASE("Errors name the place and what was expected", "[authors_repr]") {
  CHECK(ErrorOf("[]") ==
        "0: '{' at the start of the dictionary is expected, not '['");
  CHECK(ErrorOf("{<Alphabet.BLOCK 'B'>") ==
        "20: ':' behind the name is expected, not '>'");
  CHECK(ErrorOf("{<Alphabet.BLOCK: 'B'>: [[[['hot', '<', 3]]]]}") ==
        "35: '==' or '!=' is expected, not '<'");
  CHECK(ErrorOf("{<Alphabet.BLOCK: 'B'>: [[[['hot', '==', 1]]]]}") ==
        "41: 'False' or 'True' is expected, not '1'");
}

}  // namespace
}  // namespace plsc
