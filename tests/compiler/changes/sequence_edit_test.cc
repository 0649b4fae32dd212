#include "compiler/changes/sequence_edit.h"

#include <catch2/catch.hpp>

#include <string>

#include "tests/compiler/changes/merge_rows.h"

namespace plsc {
namespace {

using test::LetterCosts;
using test::Letters;

// Each letter that stays or becomes another, with '-' for those that are gone
// and what is inserted in parentheses: "a(x)-c".
std::string Shown(const std::string& to, const SequenceEdit& edit) {
  std::string text;
  for (std::size_t i = 0; i < edit.inserted.size(); ++i) {
    if (!edit.inserted[i].empty()) {
      text += '(';
      for (const int j : edit.inserted[i])
        text += to[static_cast<std::size_t>(j)];
      text += ')';
    }
    if (i == edit.becomes.size()) break;
    const int j = edit.becomes[i];
    text += j == kNoElement ? '-' : to[static_cast<std::size_t>(j)];
  }
  return text;
}

TEST_CASE("FindEdit finds the cheapest edit", "[sequence_edit]") {
  struct Row {
    const char* why;
    std::string from;
    std::string to;
    std::string early;
    std::string late;
  };
  const std::vector<Row> rows = {
      {"nothing changed", "abc", "abc", "abc", "abc"},
      {"from nothing", "", "ab", "(ab)", "(ab)"},
      {"to nothing", "ab", "", "--", "--"},
      {"an insertion", "abc", "axbc", "a(x)bc", "a(x)bc"},
      {"a deletion", "abc", "ac", "a-c", "a-c"},
      {"another letter", "abc", "axc", "axc", "axc"},
      {"neighbours swapped are replaced", "abcd", "acbd", "acbd", "acbd"},
      {"distant ones too", "abcde", "adcbe", "adcbe", "adcbe"},
      {"one of equals is gone", "abbc", "abc", "a-bc", "ab-c"},
      {"one more of equals", "abc", "abbc", "a(b)bc", "ab(b)c"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const EditCosts costs = LetterCosts(row.from, row.to);
      const auto shown = [&](EditPreference preference) {
        return Shown(row.to, FindEdit(row.from.size(), row.to.size(), costs,
                                      preference));
      };
      CHECK(shown(EditPreference::kEarly) == row.early);
      CHECK(shown(EditPreference::kLate) == row.late);
    }
  }
}

TEST_CASE("FindEdit of long sequences aligns what is between equal ends",
          "[sequence_edit]") {
  std::string from(5000, 'a');
  for (std::size_t i = 0; i < from.size(); ++i)
    from[i] = static_cast<char>('a' + i % 26);
  std::string to = from;
  to.erase(2500, 1);
  to.insert(2600, "!");
  const SequenceEdit edit = FindEdit(
      from.size(), to.size(), LetterCosts(from, to), EditPreference::kEarly);
  CHECK(edit.becomes[2500] == kNoElement);
  CHECK(edit.becomes[2501] == 2500);
  CHECK(edit.inserted[2601] == std::vector<int>{2600});
  CHECK(edit.becomes[4999] == 4999);
}

TEST_CASE("FindEdit pairs in order what is too long to align",
          "[sequence_edit]") {
  const std::string from(3000, 'a');
  const std::string to = "x" + std::string(2500, 'b') + "y";
  const SequenceEdit edit = FindEdit(
      from.size(), to.size(), LetterCosts(from, to), EditPreference::kEarly);
  CHECK(edit.becomes[0] == 0);
  CHECK(edit.becomes[2501] == 2501);
  CHECK(edit.becomes[2502] == kNoElement);
  const SequenceEdit back = FindEdit(
      to.size(), from.size(), LetterCosts(to, from), EditPreference::kLate);
  CHECK(back.inserted[2502].size() == 498);
}

TEST_CASE("FindSwaps tells what moved from what became another",
          "[sequence_edit]") {
  const auto swaps = [](const std::string& from, const std::string& to) {
    return FindSwaps(FindEdit(from.size(), to.size(), LetterCosts(from, to),
                              EditPreference::kEarly),
                     Letters(from), Letters(to))
        .swapped;
  };
  using Pairs = std::vector<std::pair<int, int>>;
  CHECK(swaps("abcde", "adcbe") == Pairs{{1, 3}});
  CHECK(swaps("ab", "ba") == Pairs{{0, 1}});
  CHECK(swaps("abc", "axc").empty());
  CHECK(swaps("abc", "bca").empty());  // three changed places
  CHECK(swaps("abxyzcd", "baxyzdc") == Pairs{{0, 1}, {5, 6}});
}

}  // namespace
}  // namespace plsc
