#include "grammar/suggest.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("Edits are insertions, deletions, replacements and swaps",
          "[suggest]") {
  struct Row {
    const char* a;
    const char* b;
    int distance;
  };
  const std::vector<Row> rows = {
      {"", "", 0},
      {"", "abc", 3},
      {"rule", "rule", 0},
      {"rulle", "rule", 1},
      {"rlue", "rule", 1},
      {"rxle", "rule", 1},
      {"kitten", "sitting", 3},
      {"ca", "abc", 3},
  };
  for (const Row& row : rows) {
    CAPTURE(row.a, row.b);
    CHECK(EditDistance(row.a, row.b) == row.distance);
    CHECK(EditDistance(row.b, row.a) == row.distance);
  }
}

TEST_CASE("Only a word that is near is suggested", "[suggest]") {
  static constexpr std::string_view kKnown[] = {"inclined", "hot", "move_left",
                                                "move_right", "B"};
  struct Row {
    const char* why;
    const char* word;
    const char* suggested;  // nullptr: none
  };
  const std::vector<Row> rows = {
      {"one edit in seven letters", "inclind", "inclined"},
      {"two edits in nine letters", "inclinnedd", "inclined"},
      {"one edit in three letters", "hat", "hot"},
      {"two edits in three letters are too many", "hxx", nullptr},
      {"three edits are too many", "inclixxx", nullptr},
      {"two edits in five letters are more than a third", "hottt", nullptr},
      {"only the case differs", "b", "B"},
      {"of two, the nearer", "move_righ", "move_right"},
      {"nothing is near", "wheel", nullptr},
      {"the empty word is near nothing", "", nullptr},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const auto suggested = Suggest(row.word, kKnown);
      REQUIRE(suggested.has_value() == (row.suggested != nullptr));
      if (suggested) CHECK(*suggested == row.suggested);
    }
  }
}

TEST_CASE("A suggestion is a label and a fix of what stands there",
          "[suggest]") {
  static constexpr std::string_view kWords[] = {"axiom", "alphabet"};
  Diagnostic diagnostic(Code::kUnknownItem, {3, 8}, "m");
  CHECK_FALSE(AddSuggestion("zzzzzz", kWords, &diagnostic));
  CHECK(diagnostic.label.empty());
  CHECK(diagnostic.fixes.empty());
  CHECK(AddSuggestion("axium", kWords, &diagnostic));
  CHECK(diagnostic.label == "did you mean 'axiom'?");
  REQUIRE(diagnostic.fixes.size() == 1);
  CHECK(diagnostic.fixes[0].span == Span{3, 8});
  CHECK(diagnostic.fixes[0].replacement == "axiom");
}

}  // namespace
}  // namespace plsc
