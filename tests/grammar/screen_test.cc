#include "grammar/screen.h"

#include <catch2/catch.hpp>
#include <string>

namespace plsc {
namespace {

TEST_CASE("What is not a genotype text is named", "[screen]") {
  struct Row {
    const char* why;
    std::string text;
    const char* code;  // nullptr: nothing is wrong
    std::uint32_t offset;
  };
  const std::vector<Row> rows = {
      {"a text", "plsc 1\n", nullptr, 0},
      {"UTF-8 in a comment", "plsc 1 # \xC3\xA9 \xE2\x82\xAC \xF0\x9F\xA4\x96",
       nullptr, 0},
      {"a byte order mark", "\xEF\xBB\xBFplsc 1", nullptr, 0},
      {"nothing", "", "P5013", 0},
      {"only blanks", " \r\n\t", "P5013", 0},
      {"only a byte order mark", "\xEF\xBB\xBF", "P5013", 0},
      {"UTF-16, little end first", std::string("\xFF\xFEp\0", 4), "P5011", 0},
      {"UTF-16, big end first", std::string("\xFE\xFF\0p", 4), "P5011", 0},
      {"Latin-1", "plsc 1 # caf\xE9\n", "P5011", 12},
      {"a character that is cut off", "plsc 1 # \xE2\x82", "P5011", 9},
      {"an overlong form", "plsc 1 # \xC0\xAF", "P5011", 9},
      {"half a surrogate pair", "plsc 1 # \xED\xA0\x80", "P5011", 9},
      {"beyond the last character", "plsc 1 # \xF4\x90\x80\x80", "P5011", 9},
      {"a zero byte", std::string("plsc 1\0x", 8), "P5016", 6},
      {"a conflict", "plsc 1\n<<<<<<< HEAD\n", "P5010", 7},
      {"the end of a conflict", "plsc 1\n>>>>>>> b\n", "P5010", 7},
      {"no marker within a line", "plsc 1 # <<<<<<<", nullptr, 0},
      {"one byte too many", std::string(kMaxSourceBytes + 1, ' '), "P5015", 0},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const auto found = Screen(Source("a", row.text));
      REQUIRE(found.has_value() == (row.code != nullptr));
      if (!found) continue;
      CHECK(NumberOf(found->code) == row.code);
      CHECK(found->span.begin == row.offset);
    }
  }
}

}  // namespace
}  // namespace plsc
