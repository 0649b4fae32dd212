#include "compiler/lint.h"

#include <catch2/catch.hpp>
#include <string>

#include "compiler/compile.h"

namespace plsc {
namespace {

TEST_CASE("Environments in which no rule is active are found", "[lint]") {
  const std::string head =
      "plsc 1\nalphabet plasticoding 1\nsense a: bool\nsense b: bool\n";
  struct Row {
    const char* why;
    const char* rules;
    const char* message;  // "" for none
  };
  const std::vector<Row> rows = {
      {"no rules, no gap", "", ""},
      {"always active", "rule B -> { B }", ""},
      {"two halves",
       "rule B -> if a = True then { B } rule B -> if a = False then { T(1) }",
       ""},
      {"one half", "rule B -> if a = True then { B }",
       "no rule for 'B' is active when a = False"},
      {"one of four",
       "rule B -> if a = True then { B } rule B -> if b = False then { T(1) }",
       "no rule for 'B' is active when a = False and b = True"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const Source source("a", head + row.rules);
      const Result<Program> program = Compile(source);
      REQUIRE(program);
      const std::vector<Diagnostic> found = Lint(*program, source);
      REQUIRE(found.size() == (*row.message == '\0' ? 0 : 1));
      if (found.empty()) continue;
      CHECK(found[0].code == "W3003");
      CHECK(found[0].severity == Severity::kWarning);
      CHECK(found[0].message == row.message);
      CHECK(source.text().substr(found[0].span.begin, 1) == "B");
    }
  }
}

TEST_CASE("A gap tells how large it is", "[lint]") {
  const Source source("a",
                      "plsc 1 alphabet plasticoding 1 sense a: bool "
                      "sense b: bool rule T -> if a = True and b = True then "
                      "{ T(1) }");
  const Result<Program> program = Compile(source);
  REQUIRE(program);
  const std::vector<Diagnostic> found = Lint(*program, source);
  REQUIRE(found.size() == 1);
  CHECK(found[0].label == "T stays as it is in 3 of 4 environments");
}

}  // namespace
}  // namespace plsc
