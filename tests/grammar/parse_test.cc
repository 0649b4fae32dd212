#include "grammar/parse.h"

#include <catch2/catch.hpp>
#include <string>

namespace plsc {
namespace {

std::string Codes(const ParseResult& result) {
  std::string codes;
  for (const Diagnostic& diagnostic : result.diagnostics)
    codes +=
        (codes.empty() ? "" : " ") + std::string(NumberOf(diagnostic.code));
  return codes;
}

TEST_CASE("A rule keeps the bytes of all its parts", "[parse]") {
  const Source source(
      "a",
      "plsc 1\nrule A1 -> if hot = True and t >= -2.5 or g != wet then "
      "{ A1(1, -0.5e1, w) B }");
  const ParseResult result = Parse(source);
  REQUIRE(result.diagnostics.empty());
  const ast::File& file = result.file;
  REQUIRE(file.rules.size() == 1);
  const ast::Rule& rule = file.rules[0];
  CHECK(file.Text(rule.head) == "A1");
  CHECK(file.Text(rule.clause) == "hot = True and t >= -2.5 or g != wet");
  CHECK(file.Text(file.items[0].span) == source.text().substr(7));
  CHECK(file.Text({rule.open.begin, rule.close.end}) ==
        "{ A1(1, -0.5e1, w) B }");

  const auto terms = ast::Slice(file.terms, rule.terms);
  REQUIRE(terms.size() == 3);
  CHECK(terms[0].connective == ast::Connective::kNone);
  CHECK(terms[1].connective == ast::Connective::kAnd);
  CHECK(terms[2].connective == ast::Connective::kOr);
  CHECK(terms[1].comparison == ast::Comparison::kGreaterEqual);
  CHECK(terms[1].value.number == -2.5);
  CHECK(terms[2].value.kind == ast::Value::Kind::kName);

  const auto symbols = ast::Slice(file.symbols, rule.symbols);
  REQUIRE(symbols.size() == 2);
  CHECK(file.Text(symbols[0].span) == "A1(1, -0.5e1, w)");
  const auto arguments = ast::Slice(file.arguments, symbols[0].arguments);
  REQUIRE(arguments.size() == 3);
  CHECK(arguments[0].is_integer);
  CHECK_FALSE(arguments[1].is_integer);
  CHECK(arguments[1].number == -5);
  CHECK(symbols[1].arguments.count == 0);
}

TEST_CASE("Blanks, line ends and comments may stand between any two tokens",
          "[parse]") {
  const std::string plain =
      "plsc 1 rule B -> if a < 1 then { T ( 0.5 , 2 ) B } "
      "sense t : real in -40..60 alphabet m { replaceable X ( a : int ) ; }";
  for (const char* between : {"\n", "\r\n", "\t", " # c\n", "# rule x\r\n"}) {
    std::string text;
    for (const char c : plain) c == ' ' ? text += between : text += c;
    const ParseResult result = Parse(Source("a", text));
    CAPTURE(text);
    CHECK(Codes(result).empty());
    CHECK(result.file.items.size() == 3);
  }
}

TEST_CASE("Parsing goes on at the next item", "[parse]") {
  struct Row {
    const char* why;
    const char* text;
    const char* codes;
    std::size_t items;  // that were kept
  };
  const std::vector<Row> rows = {
      {"an unclosed production", "rule B -> {\n B\nrule T -> { B }", "P1107",
       1},
      {"a symbol that is no symbol",
       "rule B -> {\n B\n %\n T\n}\nrule T -> { B }", "P1116", 1},
      {"four errors, four reports",
       "rulle\niterations\nrule B -> }\nsense x\nrule T -> { B }",
       "P1101 P1108 P1115 P1115", 1},
      {"an indented item counts", "%\n  rule T -> { B }", "P1101", 1},
      {"an item behind on the line counts", "% rule T -> { B }", "P1101", 1},
      {"two broken items on a line",
       "rule B -> { % } rule T -> { & } let a = 3", "P1116 P1116", 1},
      {"each of the items that a line may go on with",
       "% sense a: bool % alphabet a 1 % let a = 1 % environment a { } "
       "% test a -> { B } % test b in c -> { B }",
       "P1101 P1101 P1101 P1101 P1101 P1101", 6},
      {"a word that is reserved is no item", "sense rule: bool\naxiom rule",
       "P1102 P1102", 0},
      {"nor in a production", "rule B -> { B rule T }\naxiom B", "P1107", 1},
      {"nor the end of a longer word", "% my_rule T -> { B }", "P1101", 0},
      {"nor in a comment", "% # rule T -> { B }", "P1101", 0},
      {"a keyword within a word is none", "%\nruler\nrule T -> { B }", "P1101",
       1},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const std::string text = std::string("plsc 1\n") + row.text;
      const ParseResult result = Parse(Source("a", text));
      CHECK(Codes(result) == row.codes);
      CHECK(result.file.items.size() == row.items);
      CHECK(result.file.is_incomplete);
    }
  }
}

TEST_CASE("Numbers are what the grammar says, not what a library accepts",
          "[parse]") {
  struct Row {
    const char* text;
    const char* code;  // "" when it is a number
    double value;
  };
  const std::vector<Row> rows = {
      {"0", "", 0},
      {"-0", "", -0.0},
      {"007", "", 7},
      {"1.5", "", 1.5},
      {"1e5", "", 1e5},
      {"1e+05", "", 1e5},
      {"1E-5", "", 1e-5},
      {"4.9406564584124654e-324", "", 4.9406564584124654e-324},
      {"1.7976931348623157e308", "", 1.7976931348623157e308},
      {"0e999", "", 0},
      {"0.0e-999", "", 0},
      {"1e309", "P1112", 0},
      {"1e-324", "P1112", 0},
      {"1.", "P1110", 0},
      {".5", "P1110", 0},
      {"+1", "P1110", 0},
      {"1e", "P1110", 0},
      {"1..5", "P1109", 0},
      {"--1", "P1108", 0},
      {"1x", "P1110", 0},
      {"0x1", "P1111", 0},
      {"1_0", "P1111", 0},
      {"-inf", "P1111", 0},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.text) {
      const std::string text =
          std::string("plsc 1\nrule T -> { T(") + row.text + ") }";
      const ParseResult result = Parse(Source("a", text));
      CHECK(Codes(result) == row.code);
      if (*row.code != '\0') continue;
      CHECK(result.file.arguments[0].number == row.value);
      CHECK(std::signbit(result.file.arguments[0].number) ==
            std::signbit(row.value));
    }
  }
}

TEST_CASE("Comments are kept with their bytes, without a carriage return",
          "[parse]") {
  const Source source("a", "# one\r\nplsc 1 # two\r\n#\nrule B -> { B # 3\n}");
  const ParseResult result = Parse(source);
  REQUIRE(result.diagnostics.empty());
  REQUIRE(result.file.comments.size() == 4);
  CHECK(result.file.Text(result.file.comments[0]) == "# one");
  CHECK(result.file.Text(result.file.comments[1]) == "# two");
  CHECK(result.file.Text(result.file.comments[2]) == "#");
  CHECK(result.file.Text(result.file.comments[3]) == "# 3");
}

TEST_CASE("A file of another version is not judged", "[parse]") {
  const ParseResult result = Parse(Source("a", "plsc 2\nwhatever\n%"));
  CHECK(Codes(result) == "P5002");
}

TEST_CASE("No more than a thousand errors are kept", "[parse]") {
  std::string text = "plsc 1\n";
  for (int i = 0; i < 5000; ++i) text += "rule\n";
  CHECK(Parse(Source("a", text)).diagnostics.size() == 1000);
}

}  // namespace
}  // namespace plsc
