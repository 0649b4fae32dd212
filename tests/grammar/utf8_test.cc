#include "grammar/utf8.h"

#include <catch2/catch.hpp>
#include <vector>

namespace plsc {
namespace {

TEST_CASE("long texts are cut between characters", "[utf8]") {
  struct Row {
    const char* text;
    std::size_t letters;
    const char* expected;
  };
  const std::vector<Row> rows = {
      {"", 0, ""},           {"abcdef", 6, "abcdef"}, {"abcdefg", 6, "abc..."},
      {"ééé", 3, "ééé"},     {"éééé", 3, "..."},      {"ééééé", 4, "é..."},
      {"abcdefg", 1, "..."},
  };
  for (const Row& row : rows) {
    INFO(row.text);
    CHECK(Shortened(row.text, row.letters) == row.expected);
  }
  CHECK(CountCharacters("aé€") == 3);
}

TEST_CASE("a byte begins a character or goes on with it", "[utf8]") {
  const std::string_view euro = "€";
  CHECK_FALSE(GoesOn(euro[0]));
  CHECK(GoesOn(euro[1]));
  CHECK(GoesOn(euro[2]));
  CHECK_FALSE(GoesOn('e'));
}

TEST_CASE("Characters are decoded, and what is none is one byte", "[utf8]") {
  struct Row {
    std::string_view text;
    std::size_t bytes;
    char32_t code;
    bool is_valid;
  };
  const std::vector<Row> rows = {
      {"a", 1, U'a', true},         {"\u00e9x", 2, 0xE9, true},
      {"\u20acx", 3, 0x20AC, true}, {"\U0001F40Cx", 4, 0x1F40C, true},
      {"\xE2\x82", 1, 0, false},    {"\xE2xx", 1, 0, false},
      {"\x82", 1, 0, false},        {"\xFF", 1, 0, false},
  };
  for (const Row& row : rows) {
    CAPTURE(row.text);
    const Character character = DecodeCharacter(row.text, 0);
    CHECK(character.bytes == row.bytes);
    CHECK(character.code == row.code);
    CHECK(character.is_valid == row.is_valid);
  }
  CHECK(CharacterLength("x\u20acy", 1) == 3);
  CHECK(CharacterLength("x\u20ac", 3) == 1);
}

}  // namespace
}  // namespace plsc
