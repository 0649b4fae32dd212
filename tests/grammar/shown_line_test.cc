#include "grammar/shown_line.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

std::string Whole(std::string_view line) {
  const ShownLine shown = ShownLineOf(line);
  return shown.Text(0, shown.columns.size());
}

TEST_CASE("what is shown of a line is harmless", "[shown_line]") {
  struct Row {
    const char* why;
    std::string line;
    std::string shown;
  };
  const std::vector<Row> rows = {
      {"plain text stays", "rule C", "rule C"},
      {"characters of any length stay", "tö \xE2\x82\xAC \xF0\x9F\xA4\x96",
       "tö \xE2\x82\xAC \xF0\x9F\xA4\x96"},
      {"tabs go to every fourth column", "a\tb\tc", "a   b   c"},
      {"escape sequences lose their escape", "\x1B[31mred", "?[31mred"},
      {"so do the 8-bit controls",
       "\xC2\x9B"
       "31m",
       "?31m"},
      {"text is not turned around",
       "a\xE2\x80\xAE"
       "b",
       "a?b"},
      {"bytes that are no UTF-8", "\xFF\xC3-",
       "?"
       "?-"},
      {"a character cut at the end", "a\xE2\x82",
       "a?"
       "?"},
      {"NUL", std::string("a\0b", 3), "a?b"},
  };
  for (const Row& row : rows) DYNAMIC_SECTION(row.why) {
      CHECK(Whole(row.line) == row.shown);
    }
}

TEST_CASE("every byte knows its column", "[shown_line]") {
  const ShownLine shown = ShownLineOf("ö\tx");
  CHECK(shown.column_of_byte == std::vector<std::size_t>{0, 0, 1, 4, 5});
}

TEST_CASE("long text is cut by characters", "[shown_line]") {
  CHECK(Printable("abc", 3) == "abc");
  CHECK(Printable("abcd", 3) == "abc...");
  CHECK(Printable("öööö", 3) == "ööö...");
  CHECK(Printable(std::string(1000000, 'x'), 5) == "xxxxx...");
  CHECK(Printable("", 0).empty());
}

TEST_CASE("a name in a line of ours stays in it", "[shown_line]") {
  CHECK(Escaped("") == "");
  CHECK(Escaped("season 1, \"t\xC3\xB6\" \\ \xE2\x82\xAC") ==
        "season 1, \"t\xC3\xB6\" \\ \xE2\x82\xAC");
  CHECK(Escaped("a\nb\rc\td") == "a\\nb\\rc\\td");
  CHECK(Escaped("\x1B[31mred\x7F") == "\\x1b[31mred\\x7f");
  CHECK(Escaped(std::string_view("\0", 1)) == "\\x00");
  CHECK(Escaped("\xC2\x9B"
                "31m") == "\\u009b31m");
  CHECK(Escaped("a\xE2\x80\xAE"
                "b") == "a\\u202eb");
  CHECK(Escaped("\xFF\xC3") == "\\xff\\xc3");
}

}  // namespace
}  // namespace plsc
