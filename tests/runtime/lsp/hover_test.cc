#include "runtime/lsp/hover.h"

#include <catch2/catch.hpp>

#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

namespace {

std::string Text(const std::string& text, std::string_view at) {
  Analysis analysis(kTestUri, text);
  const Json hover = Hover(analysis, static_cast<std::uint32_t>(text.find(at)));
  if (hover.is_null()) return "";
  CHECK(hover["contents"]["kind"] == "markdown");
  CHECK(hover.contains("range"));
  return hover["contents"]["value"];
}

}  // namespace

TEST_CASE("Hovers say what a name is", "[lsp]") {
  struct Row {
    const char* why;
    const char* at;
    const char* says;
  };
  const std::vector<Row> rows = {
      {"a symbol's documentation", "add_left", "to the left of"},
      {"how many rules rewrite it", "C\n  add_left", "2 rules here rewrite it"},
      {"a rule's head", "B -> {", "1 rule here rewrites it"},
      {"a state", "inclined: bool", "sense inclined: bool"},
      {"the clause around a state", "warmth > mild", "Active in 5 of 8"},
      {"the clause around a constant", "mild and", "Active in 5 of 8"},
      {"the clause around a comparison", "> mild", "Active in 5 of 8"},
      {"a constant as an argument", "half, 1.6", "let half = 0.5"},
      {"the argument's parameter", "half, 1.6", "weight of the neuron's edges"},
      {"a number's parameter", "6.4", "period of the oscillation, s"},
      {"an environment", "flat after", "inclined=False,warmth=20,ground=dry"},
      {"a genotype", "gecko", "3 rules"},
      {"a value", "wet }", "a value of a state"},
      {"a keyword", "sense", "a state that clauses may ask about"},
      {"the version", "plsc", "the version of the language"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(Text(kGecko, row.at).find(row.says) != std::string::npos);
    }
  }
}

TEST_CASE("There is nothing to say of blanks and comments", "[lsp]") {
  CHECK(Text(kGecko, "\n\ngenotype").empty());
  CHECK(Text("plsc 1\n# about rule\n", "ule").empty());
  CHECK(Text("", "").empty());
}

TEST_CASE("Broken texts have hovers where they can be read", "[lsp]") {
  const std::string text =
      "plsc 1\nalphabet plasticoding 1\nsense a: bool\n"
      "rule C -> if a = True and b = True then { C }\nrule B -> { T( }\n";
  CHECK(Text(text, "a: bool").find("sense a: bool") != std::string::npos);
  CHECK(Text(text, "C }").find("core component") != std::string::npos);
  // No truth table of what has no meaning.
  CHECK(Text(text, "b = True").empty());
  // Of an item that could not be read its keywords at least.
  CHECK_FALSE(Text(text, "rule B").empty());
}

}  // namespace plsc::lsp
