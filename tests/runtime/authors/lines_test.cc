#include <catch2/catch.hpp>

#include "runtime/authors/genotype.h"

namespace plsc {
namespace {

TEST_CASE("Lines are read word by word", "[authors_lines]") {
  const Source source("test",
                      "C C brainmoveFTS_2.0|3.0 addf \r\n\n  B ST_-0.5 \n");
  const AuthorsText read = ReadAuthorsLines(source);
  REQUIRE(read.rules.size() == 2);
  CHECK(read.rules[0].letter.token == "C");
  REQUIRE(read.rules[0].symbols.size() == 3);
  CHECK(read.rules[0].symbols[1].parameters[1].value == 3);
  CHECK(source.text().substr(read.rules[0].symbols[1].parameters[1].span.begin,
                             3) == "3.0");
  CHECK(read.rules[1].symbols[0].parameters[0].value == -0.5);
  CHECK_FALSE(read.has_clauses);
  CHECK(read.problems.empty());
}

TEST_CASE("Losses of lines are said where they are", "[authors_lines]") {
  const Source source("test", "B ST_0.123456 addl\nC C ST_0.654321 addf ");
  const AuthorsText read = ReadAuthorsLines(source);
  REQUIRE(read.problems.size() == 2);
  CHECK(read.problems[0].span == Span{14, 18});
  CHECK(read.problems[1].span == Span{5, 13});  // the first number only
}

}  // namespace
}  // namespace plsc
