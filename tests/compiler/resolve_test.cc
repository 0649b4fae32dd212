#include "compiler/resolve.h"

#include <catch2/catch.hpp>
#include <string>

#include "compiler/compiled.h"
#include "grammar/parse.h"

namespace plsc {
namespace {

using testing::CodesOf;

TEST_CASE("Names become numbers, parallel to the tree", "[resolve]") {
  const Source source("a",
                      "plsc 1 alphabet plasticoding 1 sense hot: bool\n"
                      "sense g: { dry, wet } let w = 0.5\n"
                      "rule T -> if g != wet or hot = False then { T(w) nix }\n"
                      "environment e { hot = True, g = dry }");
  const ParseResult parsed = Parse(source);
  REQUIRE(parsed.diagnostics.empty());
  const Scope scope = Declare(parsed.file);
  const Resolution resolution = Resolve(parsed.file, scope);
  CHECK(resolution.heads[0] == plasticoding::kT);
  CHECK(resolution.symbols[0] == plasticoding::kT);
  CHECK_FALSE(resolution.symbols[1]);
  CHECK(resolution.arguments[0].value == 0.5);
  REQUIRE(resolution.terms[0]);
  CHECK(resolution.terms[0]->state == StateId{1});
  CHECK(resolution.terms[0]->comparison == Comparison::kNotEqual);
  CHECK(resolution.terms[0]->value == 1);
  CHECK(resolution.entries[0]->value == 1);
  CHECK(resolution.entries[1]->value == 0);
  REQUIRE(resolution.diagnostics.size() == 1);
  CHECK(resolution.diagnostics[0].code == Code::kUnknownSymbol);
}

TEST_CASE("Values must fit the type of their state", "[resolve]") {
  const std::string head =
      "plsc 1 alphabet plasticoding 1 sense b: bool "
      "sense r: real in 0..1 sense e: { x, y } let k = 0.5 rule B -> if ";
  struct Row {
    const char* clause;
    const char* codes;
  };
  const std::vector<Row> rows = {
      {"b = True", ""},      {"b != False", ""}, {"r >= 0.5", ""},
      {"r < k", ""},         {"e = x", ""},      {"e != y", ""},
      {"b = 1", "P2006"},    {"b = x", "P2006"}, {"b > True", "P2006"},
      {"r = True", "P2006"}, {"r = x", "P2009"}, {"e = z", "P2006"},
      {"e = 1", "P2006"},    {"e < x", "P2006"}, {"z = True", "P2005"},
      {"r = nan", "P1111"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.clause) {
      CHECK(CodesOf(head + row.clause + " then { B }") == row.codes);
    }
  }
}

TEST_CASE("States are not missed when a declaration may be broken",
          "[resolve]") {
  CHECK(CodesOf("plsc 1 alphabet plasticoding 1\nsense hot bool\n"
                "rule B -> if hot = True then { B }") == "P1115");
}

TEST_CASE("The last of a thousand errors is told as the first", "[resolve]") {
  const std::string head =
      "plsc 1 alphabet plasticoding 1 sense hot: bool let speed = 0.5\n"
      "sense ground: { dry, wet } environment e { hot = True ground = dry }\n";
  for (const char* item :
       {"rule B -> { add_lef }", "rule B -> { AJ1 }", "rule B -> { T(sped) }",
        "rule B -> if hod = True then { B }",
        "rule B -> if ground = wett then { B }",
        "rule B -> if hot = 1 then { B }",
        "test t in e -> body C { frond B }"}) {
    CAPTURE(item);
    std::string text = head;
    for (std::size_t i = 0; i < kMaxReported + 3; ++i)
      text += item + std::string("\n");
    const Source source("a", text);
    const ParseResult parsed = Parse(source);
    REQUIRE(parsed.diagnostics.empty());
    const Resolution resolution = Resolve(parsed.file, Declare(parsed.file));
    REQUIRE(resolution.diagnostics.size() == kMaxReported);
    const Diagnostic& first = resolution.diagnostics.front();
    const Diagnostic& last = resolution.diagnostics.back();
    CHECK(last.message == first.message);
    CHECK(last.label == first.label);
    CHECK_FALSE(last.label.empty());
    CHECK(last.fixes.size() == first.fixes.size());
    CHECK(last.notes == first.notes);
    CHECK(last.others.size() == first.others.size());
  }
}

}  // namespace
}  // namespace plsc
