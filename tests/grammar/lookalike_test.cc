#include "grammar/lookalike.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("Characters that look like others are named", "[lookalike]") {
  struct Row {
    const char* text;
    const char* code;  ///< empty: it looks like nothing of plsc
    const char* intended;
  };
  const Row rows[] = {
      {"", "", ""},
      {"-", "", ""},
      {"\xC3\xA9", "", ""},
      {"\xF0\x9F\xA6\x8E", "", ""},
      {"\xC2\xA0x", "U+00A0", " "},
      {"\xE2\x80\x8B", "U+200B", ""},
      {"\xE2\x88\x92", "U+2212", "-"},
      {"\xE2\x80\x9C", "U+201C", ""},
      {"\xE2\x80\x99", "U+2019", ""},
      {"\xEF\xBC\x95", "U+FF15", "5"},
      {"\xEF\xBC\x81", "U+FF01", "!"},
      {"\xEF\xBD\x9E", "U+FF5E", "~"},
      {"\xD0\x92", "U+0412", "B"},
      {"\xE2\x89\xA4", "U+2264", "<="},
      {"\xE2\x80\x83", "U+2003", " "},
  };
  for (const Row& row : rows) {
    CAPTURE(row.text);
    const auto found = LookalikeAt(row.text);
    REQUIRE(found.has_value() == (row.code[0] != '\0'));
    if (!found) continue;
    CHECK(found->code == row.code);
    CHECK(found->intended == row.intended);
    CHECK(found->bytes == (row.code[2] == '0' ? 2U : 3U));
    CHECK_FALSE(found->name.empty());
    CHECK(CodePointText(row.text) == row.code);
  }
  CHECK(CodePointText("\xF0\x9F\xA6\x8E") == "U+1F98E");
  CHECK(CodePointText("\xC3\xA9") == "U+00E9");
}

}  // namespace
}  // namespace plsc
