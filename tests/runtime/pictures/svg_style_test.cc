#include "runtime/pictures/svg_style.h"

#include <catch2/catch.hpp>
#include <set>
#include <vector>

namespace plsc {
namespace {

TEST_CASE("text is safe in XML", "[svg_style]") {
  CHECK(EscapeXml("a<b> & \"c\" \x01\n\u00e9") ==
        "a&lt;b&gt; &amp; &quot;c&quot; \u00e9");
}

TEST_CASE("every module has a colour of its own", "[svg_style]") {
  for (int a = 0; a <= static_cast<int>(ModuleType::kTouchSensor); ++a)
    for (int b = 0; b < a; ++b)
      CHECK(ModuleColour(static_cast<ModuleType>(a)) !=
            ModuleColour(static_cast<ModuleType>(b)));
}

TEST_CASE("long texts are cut between characters", "[svg_style]") {
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

TEST_CASE("eight numbers have colours of their own", "[svg_style]") {
  std::set<std::string_view> fills;
  for (std::size_t i = 0; i < 8; ++i) fills.insert(NumberColour(i).fill);
  CHECK(fills.size() == 8);
  CHECK(NumberColour(8).fill == NumberColour(0).fill);
}

}  // namespace
}  // namespace plsc
