#include "runtime/lsp/line_table.h"

#include <catch2/catch.hpp>
#include <random>
#include <string>
#include <vector>

namespace plsc::lsp {

TEST_CASE("Characters are counted in UTF-16 code units", "[lsp]") {
  CHECK(Utf16Length("") == 0);
  CHECK(Utf16Length("abc") == 3);
  CHECK(Utf16Length("\xC3\xA9") == 1);           // é
  CHECK(Utf16Length("\xE2\x82\xAC") == 1);       // €
  CHECK(Utf16Length("\xF0\x9F\xA6\x8E!") == 3);  // a gecko and '!'
  CHECK(Utf16Length("\x80\xFF\xF0\x9F") == 3);   // no UTF-8
}

TEST_CASE("Places and bytes are found from each other", "[lsp]") {
  struct Row {
    const char* why;
    std::string text;
    std::uint32_t offset;
    Place place;
  };
  const std::string gecko = "\xF0\x9F\xA6\x8E";
  const std::vector<Row> rows = {
      {"the start", "ab", 0, {0, 0}},
      {"the end", "ab", 2, {0, 2}},
      {"a second line", "a\nbc", 3, {1, 1}},
      {"after a last line's end", "a\n", 2, {1, 0}},
      {"behind an emoji", "# " + gecko + "x", 6, {0, 4}},
      {"CRLF", "a\r\nbc", 4, {1, 1}},
      {"at a CRLF", "a\r\nbc", 1, {0, 1}},
      {"a lone CR ends a line", "a\rbc", 3, {1, 1}},
      {"emoji and CRLF", gecko + "\r\n" + gecko + gecko, 10, {1, 2}},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const LineTable lines(row.text);
      CHECK(lines.PlaceAt(row.offset) == row.place);
      CHECK(lines.OffsetAt(row.place) == row.offset);
    }
  }
}

TEST_CASE("Places outside of the text come to its edge", "[lsp]") {
  const std::string text = "ab\r\n\xF0\x9F\xA6\x8E";
  const LineTable lines(text);
  CHECK(lines.line_count() == 2);
  CHECK(lines.OffsetAt({0, 99}) == 2);
  CHECK(lines.OffsetAt({7, 0}) == text.size());
  CHECK(lines.OffsetAt({0xFFFFFFFF, 0xFFFFFFFF}) == text.size());
  // The middle of a surrogate pair.
  CHECK(lines.OffsetAt({1, 1}) == 4);
  CHECK(lines.PlaceAt(1000) == Place{1, 2});
  // Between CR and LF is the line's end.
  CHECK(lines.PlaceAt(3) == Place{0, 2});
  CHECK(lines.LineEnd(0) == 2);
  CHECK(lines.LineEnd(5) == text.size());
}

TEST_CASE("An empty text has one line", "[lsp]") {
  const LineTable lines("");
  CHECK(lines.line_count() == 1);
  CHECK(lines.RangeOf({0, 0}) == PlaceRange{});
}

// Counted character by character from the line's beginning.
TEST_CASE("Places on long lines are those of short ones", "[lsp]") {
  constexpr std::uint32_t kSeed = 20261130;
  CAPTURE(kSeed);
  std::mt19937 random(kSeed);
  const std::vector<std::string> pieces = {
      "a", "bc ", "\t", "\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\xA6\x8E", "\x80"};
  std::string text;
  while (text.size() < 20000) {
    text += pieces[random() % pieces.size()];
    if (random() % 4000 == 0) text += random() % 2 == 0 ? "\n" : "\r\n";
  }
  const LineTable lines(text);
  for (int i = 0; i < 2000; ++i) {
    const auto offset = static_cast<std::uint32_t>(random() % text.size());
    if (text[offset] == '\n') continue;
    const std::size_t newline =
        offset == 0 ? std::string::npos : text.rfind('\n', offset - 1);
    const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
    const Place place = lines.PlaceAt(offset);
    REQUIRE(place.character == Utf16Length(text.substr(begin, offset - begin)));
    // Only a character's beginning comes back.
    const bool is_inside =
        (static_cast<unsigned char>(text[offset]) & 0xC0U) == 0x80U;
    if (!is_inside && text[offset] != '\r')
      REQUIRE(lines.OffsetAt(place) == offset);
  }
}

}  // namespace plsc::lsp
