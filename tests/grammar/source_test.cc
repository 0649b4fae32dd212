#include "grammar/source.h"
#include "grammar/utf8.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("Positions count lines from 1 and characters, not bytes",
          "[source]") {
  const Source source("a.pls", "one\n\xC3\xA9t\xC3\xA9 x\n\tlast");
  struct Row {
    const char* why;
    std::uint32_t offset;
    int line;
    int column;
  };
  const std::vector<Row> rows = {
      {"first byte", 0, 1, 1},
      {"the line's end belongs to the line", 3, 1, 4},
      {"first byte of a line", 4, 2, 1},
      {"after a character of two bytes", 6, 2, 2},
      {"after two of them", 9, 2, 4},
      {"a tab is one character", 13, 3, 2},
      {"beyond the end is the end", 999, 3, 6},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const Position at = source.PositionOf(row.offset);
      CHECK(at.line == row.line);
      CHECK(at.column == row.column);
    }
  }
}

TEST_CASE("An offset is found from line and column", "[source]") {
  const Source source("a.pls", "one\n\xC3\xA9t\xC3\xA9 x\r\n\tlast");
  struct Row {
    const char* why;
    Position position;
    std::optional<std::uint32_t> expected;
  };
  const std::vector<Row> rows = {
      {"first byte", {1, 1}, 0},
      {"behind the last character", {1, 4}, 3},
      {"beyond that is nothing", {1, 5}, std::nullopt},
      {"after a character of two bytes", {2, 2}, 6},
      {"an end of two bytes is behind too", {2, 6}, 11},
      {"no column 0", {1, 0}, std::nullopt},
      {"no line 0", {0, 1}, std::nullopt},
      {"no such line", {4, 1}, std::nullopt},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(source.OffsetOf(row.position) == row.expected);
    }
  }
}

TEST_CASE("Lines come without their ends", "[source]") {
  const Source source("a.pls", "one\r\ntwo\n\nlast");
  REQUIRE(source.line_count() == 4);
  CHECK(source.Line(1) == "one");
  CHECK(source.Line(2) == "two");
  CHECK(source.Line(3).empty());
  CHECK(source.Line(4) == "last");
  CHECK(source.LineBegin(2) == 5);
  CHECK(Source("e", "").line_count() == 1);
  CHECK(Source("e", "").Line(1).empty());
}

TEST_CASE("Places are right on a line of any length", "[source]") {
  std::string text = "short\n";
  for (int i = 0; i < 60000; ++i) text += i % 3 == 0 ? "\xC3\xA9" : "ab";
  text += "\n" + std::string(70000, 'x');
  const Source source("a.pls", text);
  for (std::uint32_t offset = 0; offset < text.size(); offset += 6151) {
    CAPTURE(offset);
    const std::uint32_t begin =
        source.LineBegin(source.PositionOf(offset).line);
    int column = 1;
    for (std::uint32_t i = begin; i < offset; ++i)
      column += GoesOn(text[i]) ? 0 : 1;
    CHECK(source.PositionOf(offset).column == column);
  }
}

}  // namespace
}  // namespace plsc
