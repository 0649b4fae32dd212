#include "grammar/lookaround.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("What stands at a place is a whole token", "[lookaround]") {
  const std::string_view text = "rule B -> if a&&b { \xE2\x82\xAC";
  CHECK(FoundAt(text, 0).text == "rule");
  CHECK(FoundAt(text, 2).text == "rule");
  CHECK(FoundAt(text, 7).text == "->");
  CHECK(FoundAt(text, 14).text == "&&");
  CHECK(FoundAt(text, 18).text == "{");
  CHECK(FoundAt(text, 20).text == "\xE2\x82\xAC");
  CHECK(FoundAt(text, 23).quoted == "the end of the file");
  CHECK(FoundAt(text, 23).is_end);
  CHECK(FoundAt("\x01", 0).quoted == "character 0x01");
}

TEST_CASE("The token before a place ends there", "[lookaround]") {
  const std::string_view text = "a -> -2.5 .. x";
  CHECK(FoundBefore(text, 1).text == "a");
  CHECK(FoundBefore(text, 4).text == "->");
  CHECK(FoundBefore(text, 9).text == "-2.5");
  CHECK(FoundBefore(text, 12).text == "..");
  CHECK(FoundBefore(text, 0).text.empty());
}

TEST_CASE("The caret stays on the line of what came before", "[lookaround]") {
  SyntaxContext context;
  context.text = "iterations\nrule";
  context.offset = 11;
  context.previous_end = 10;
  CHECK(CaretOf(context) == Span{10, 10});
  context.text = "iterations rule";
  CHECK(CaretOf(context) == Span{11, 15});
}

TEST_CASE("Words of other languages have one in plsc", "[lookaround]") {
  CHECK(PlscWordFor("&&") == "and");
  CHECK(PlscWordFor("false") == "False");
  CHECK(PlscWordFor("and").empty());
}

}  // namespace
}  // namespace plsc
