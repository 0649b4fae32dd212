#include "runtime/text/utf8.h"

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
  CHECK(LettersOf("aé€") == 3);
}

TEST_CASE("a byte begins a character or goes on with it", "[utf8]") {
  const std::string_view euro = "€";
  CHECK_FALSE(GoesOn(euro[0]));
  CHECK(GoesOn(euro[1]));
  CHECK(GoesOn(euro[2]));
  CHECK_FALSE(GoesOn('e'));
}

}  // namespace
}  // namespace plsc
