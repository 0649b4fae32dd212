#include "compiler/changes/merge_order.h"

#include <catch2/catch.hpp>

#include "tests/compiler/changes/merge_rows.h"

namespace plsc {
namespace {

// Things are letters, and their own names.
std::string Ordered(const std::string& base, const std::string& ours,
                    const std::string& theirs) {
  std::vector<std::string> names;
  for (char c = 'a'; c <= 'z'; ++c) names.emplace_back(1, c);
  const auto numbers = [](const std::string& text) {
    std::vector<std::size_t> order;
    for (const char c : text)
      order.push_back(static_cast<std::size_t>(c - 'a'));
    return order;
  };
  std::string text;
  for (const std::size_t one :
       MergeOrder({numbers(base), numbers(ours), numbers(theirs)}, names))
    text += names[one];
  return text;
}

TEST_CASE("MergeOrder keeps the order that a side gave", "[merge_order]") {
  const std::vector<test::MergeRow> rows = {
      {"nothing changed", "abc", "abc", "abc", "abc"},
      {"ours moved", "abc", "cab", "abc", "cab"},
      {"theirs moved", "abc", "abc", "cab", "cab"},
      {"both added, at one place, by name", "a", "ax", "ab", "abx"},
      {"and at the front", "a", "xa", "ba", "bxa"},
      {"runs stay together", "a", "axb", "ac", "acxb"},
      {"behind what moved", "abc", "cab", "abxc", "cabx"},
      {"things of one side only", "", "ca", "b", "bca"},
  };
  test::CheckMerges(rows, Ordered);
}

TEST_CASE("MergeOrder of additions does not ask which side is ours",
          "[merge_order]") {
  CHECK(Ordered("ab", "axb", "acbz") == Ordered("ab", "acbz", "axb"));
}

}  // namespace
}  // namespace plsc
