#include "grammar/foreign_syntax.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "grammar/parse.h"

namespace plsc {
namespace {

Diagnostic FirstOf(const std::string& text) {
  const Source source("a.pls", text);
  const ParseResult parsed = Parse(source);
  REQUIRE_FALSE(parsed.diagnostics.empty());
  return parsed.diagnostics.front();
}

// The text with all changes of the diagnostic, which are in order.
std::string Mended(const std::string& text, const Diagnostic& diagnostic) {
  std::string mended;
  std::size_t copied = 0;
  for (const Fix& fix : diagnostic.fixes) {
    mended += text.substr(copied, fix.span.begin - copied) + fix.replacement;
    copied = fix.span.end;
  }
  return mended + text.substr(copied);
}

TEST_CASE("Characters that look right are named with their code and mended",
          "[foreign_syntax]") {
  struct Row {
    const char* why;
    std::string wrong;
    std::string right;
    const char* named;
  };
  const std::vector<Row> rows = {
      {"a no-break space", "let\xC2\xA0x = 1", "let x = 1", "U+00A0"},
      {"a zero width space in a name", "rule B -> { add_\xE2\x80\x8Bleft }",
       "rule B -> { add_left }", "U+200B"},
      {"a minus sign",
       "let x = \xE2\x88\x92"
       "0.5",
       "let x = -0.5", "U+2212"},
      {"curly quotes", "genotype \xE2\x80\x9Cgecko\xE2\x80\x9D",
       "genotype gecko", "U+201C"},
      {"fullwidth digits", "let x = \xEF\xBC\x90.\xEF\xBC\x95", "let x = 0.5",
       "U+FF10"},
      {"a fullwidth digit behind a point", "let x = 0.\xEF\xBC\x95",
       "let x = 0.5", "U+FF15"},
      {"a Cyrillic letter", "rule \xD0\x92 -> { B }", "rule B -> { B }",
       "U+0412"},
      {"an arrow", "rule B \xE2\x86\x92 { B }", "rule B -> { B }", "U+2192"},
      {"several, and none in comments",
       "rule B -> {\n\xC2\xA0 B # \xC2\xA0\n\xC2\xA0 B\n}",
       "rule B -> {\n  B # \xC2\xA0\n  B\n}", "U+00A0"},
      {"at an item", "\xE2\x80\x8Brule B -> { B }", "rule B -> { B }",
       "U+200B"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const std::string text = "plsc 1\n" + row.wrong + "\n";
      const Diagnostic found = FirstOf(text);
      CHECK(found.code == Code::kLookalike);
      CHECK(found.message.find(row.named) != std::string::npos);
      CHECK(Mended(text, found) == "plsc 1\n" + row.right + "\n");
    }
  }
}

TEST_CASE("Other characters are told with their code", "[foreign_syntax]") {
  CHECK(FirstOf("plsc 1\n\xC3\xA9\n").message ==
        "expected an item, found '\xC3\xA9' (U+00E9)");
}

TEST_CASE("An item's characters are mended at once, not those of others",
          "[foreign_syntax]") {
  const std::string item = "rule B -> {\n\xC2\xA0 B\n}\n";
  const Diagnostic found = FirstOf("plsc 1\n" + item + item);
  CHECK(found.fixes.size() == 1);
  std::string long_item = "rule B -> {\n";
  for (int i = 0; i < 200; ++i) long_item += "\xC2\xA0 B\n";
  CHECK(FirstOf("plsc 1\n" + long_item + "}\n" + item).fixes.size() == 200);
}

TEST_CASE("Ways of other languages get the help that they need",
          "[foreign_syntax]") {
  struct Row {
    const char* why;
    std::string wrong;
    const char* code;
    const char* told;    ///< in the help or beside the caret
    const char* mended;  ///< empty: nothing to mend without its author
  };
  const std::vector<Row> rows = {
      {"else", "rule C -> if a = True then { C } else { C B }", "P1101",
       "a second rule with the opposite clause", ""},
      {"else of a line of its own", "rule C -> { C }\nelse { C B }", "P1101",
       "a second rule", ""},
      {"a comment of C++", "// hello", "P1104", "comments begin with '#'",
       "# hello"},
      {"in a production", "rule C -> { C // core\n}", "P1104",
       "comments begin with '#'", "rule C -> { C # core\n}"},
      {"behind an item", "let x = 1 // one", "P1104", "comments begin with '#'",
       "let x = 1 # one"},
      {"a comment of C", "/* x */", "P1104", "end with the line", ""},
      {"a product", "let x = 0.5 * 2", "P1101", "write the result", ""},
      {"a sum as argument", "rule B -> { T(0.5 + 0.1) }", "P1109",
       "write the result", ""},
      {"brackets", "rule F -> { F [ F ] F }", "P1116", "push and pop", ""},
      {"arguments in brackets", "rule B -> { T[0.5] }", "P1116",
       "arguments stand in parentheses", ""},
      {"named arguments", "rule B -> { A1(w=0.5, a=2) }", "P1109",
       "arguments have no names", ""},
      {"named with a colon", "rule B -> { T(w: 0.5) }", "P1109",
       "arguments have no names", ""},
      {"a chain", "rule B -> if 10 < t < 20 then { B }", "P1105",
       "write 't > 10 and t < 20'",
       "rule B -> if t > 10 and t < 20 then { B }"},
      {"a chain of constants", "rule B -> if -1.5 <= t <= hot then { B }",
       "P1105", "write 't >= -1.5 and t <= hot'",
       "rule B -> if t >= -1.5 and t <= hot then { B }"},
      {"a reversed term", "rule B -> if 10 = t or u = 1 then { B }", "P1105",
       "write 't = 10'", "rule B -> if t = 10 or u = 1 then { B }"},
      {"a chain from the state", "rule B -> if t > 10 < 20 then { B }", "P1106",
       "STATE > LOW and STATE < HIGH", ""},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const std::string text = "plsc 1\n" + row.wrong + "\n";
      const Diagnostic found = FirstOf(text);
      INFO(Render(found, Source("a.pls", text)));
      CHECK(NumberOf(found.code) == row.code);
      CHECK((found.label + found.help).find(row.told) != std::string::npos);
      CHECK(found.fixes.empty() == (row.mended[0] == '\0'));
      if (!found.fixes.empty())
        CHECK(Mended(text, found) ==
              "plsc 1\n" + std::string(row.mended) + "\n");
    }
  }
}

}  // namespace
}  // namespace plsc
