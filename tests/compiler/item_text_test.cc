#include "compiler/item_text.h"

#include <catch2/catch.hpp>

#include "grammar/parse.h"

namespace plsc {
namespace {

TEST_CASE("Items are written with canonical blanks in their own spelling",
          "[item_text]") {
  struct Row {
    const char* item;
    const char* text;
  };
  const std::vector<Row> rows = {
      {"genotype\n g", "genotype g"},
      {"axiom  C", "axiom C"},
      {"iterations 03", "iterations 03"},
      {"move_to_new  False", "move_to_new False"},
      {"let w=1e0", "let w = 1e0"},
      {"sense a:bool", "sense a: bool"},
      {"sense r:real in 0 .. 1.50", "sense r: real in 0..1.50"},
      {"sense e:{x,y}", "sense e: { x, y }"},
      {"alphabet  plasticoding  1", "alphabet plasticoding 1"},
      {"environment e{a=True b=1.0}", "environment e { a = True, b = 1.0 }"},
      {"environment e{}", "environment e {}"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.item) {
      const Source source("a", std::string("plsc 1\n") + row.item);
      const ParseResult parsed = Parse(source);
      REQUIRE(parsed.diagnostics.empty());
      const ItemText text = TextOf(parsed.file, parsed.file.items[0], false);
      CHECK(text.open == row.text);
      CHECK_FALSE(text.has_braces);
      CHECK(text.elements.empty());
    }
  }
}

TEST_CASE("A rule has an element a symbol", "[item_text]") {
  const Source source(
      "a", "plsc 1 rule B->if a=True or b>=1 and c!=x then{T( 1 )B}");
  const ParseResult parsed = Parse(source);
  REQUIRE(parsed.diagnostics.empty());
  const ItemText text = TextOf(parsed.file, parsed.file.items[0], false);
  CHECK(text.open == "rule B -> if a = True or b >= 1 and c != x then {");
  CHECK(text.has_braces);
  REQUIRE(text.elements.size() == 2);
  CHECK(text.elements[0].text == "T(1)");
  CHECK(parsed.file.Text(text.elements[0].span) == "T( 1 )");
  CHECK(parsed.file.Text(text.braces) == "{T( 1 )B}");
}

}  // namespace
}  // namespace plsc
