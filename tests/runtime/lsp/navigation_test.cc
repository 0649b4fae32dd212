#include "runtime/lsp/navigation.h"

#include <catch2/catch.hpp>

#include "runtime/lsp/params.h"
#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

namespace {

std::uint32_t OffsetOf(std::string_view text, std::string_view what) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string_view::npos);
  return static_cast<std::uint32_t>(at);
}

// "LINE:TEXT" of each location, lines from 1.
std::vector<std::string> Shown(const Analysis& analysis, const Json& list) {
  std::vector<std::string> shown;
  for (const Json& one : list) {
    const PlaceRange range = ReadRange(one, "range");
    const std::uint32_t begin = analysis.lines().OffsetAt(range.start);
    const std::uint32_t end = analysis.lines().OffsetAt(range.end);
    shown.push_back(std::to_string(range.start.line + 1) + ":" +
                    std::string(analysis.text().substr(begin, end - begin)));
  }
  return shown;
}

}  // namespace

TEST_CASE("Names lead to what they name", "[lsp]") {
  struct Row {
    const char* why;
    const char* at;
    std::vector<std::string> places;
  };
  const std::vector<Row> rows = {
      {"a state in a clause", "inclined = False then", {"5:inclined"}},
      {"a state in an environment", "warmth = 20", {"6:warmth"}},
      {"a value", "wet then", {"7:wet"}},
      {"a constant as an argument", "half, 1.6", {"9:half"}},
      {"a constant as a threshold", "mild and", {"8:mild"}},
      {"an environment of a test", "flat after", {"23:flat"}},
      {"the rule of a symbol", "B\n}\nrule", {"21:B"}},
      {"the rules of a symbol", "C\n  add_left", {"11:C", "16:C"}},
      {"a symbol without rules", "add_left", {}},
      {"a declaration", "gecko", {"3:gecko"}},
  };
  Analysis analysis(kTestUri, std::string(kGecko));
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const auto offset = OffsetOf(analysis.text(), row.at);
      CHECK(Shown(analysis, Definition(analysis, offset)) == row.places);
    }
  }
  CHECK(Definition(analysis, 0).is_null());
}

TEST_CASE("References are all places of a name", "[lsp]") {
  Analysis analysis(kTestUri, std::string(kGecko));
  const auto offset = OffsetOf(analysis.text(), "mild and");
  CHECK(Shown(analysis, References(analysis, offset, true)) ==
        std::vector<std::string>{"8:mild", "16:mild", "24:mild"});
  CHECK(Shown(analysis, References(analysis, offset, false)) ==
        std::vector<std::string>{"16:mild", "24:mild"});
  const Json highlights = Highlights(analysis, offset);
  REQUIRE(highlights.size() == 3);
  CHECK(highlights[0]["kind"] == 3);
  CHECK(highlights[1]["kind"] == 2);
  CHECK(References(analysis, 0, true).is_null());
  CHECK(Highlights(analysis, 0).is_null());
}

TEST_CASE("Rules of another genotype are not those of a symbol", "[lsp]") {
  Analysis analysis(kTestUri,
                    "plsc 1\nalphabet plasticoding 1\n"
                    "genotype one\nrule C -> { C B }\nrule B -> { B T(0.5) }\n"
                    "genotype two\nrule C -> { C B }\nrule B -> { T(0.5) }\n");
  CHECK(Shown(analysis,
              Definition(analysis, OffsetOf(analysis.text(), "B }\nrule"))) ==
        std::vector<std::string>{"5:B"});
}

}  // namespace plsc::lsp
