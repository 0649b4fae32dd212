#include "compiler/changes/merge_text.h"

#include <catch2/catch.hpp>

#include <vector>

namespace plsc {
namespace {

TEST_CASE("MergeText takes content, comments and layout along",
          "[merge_text]") {
  struct Row {
    const char* why;
    TextVersion base;
    TextVersion ours;
    TextVersion theirs;
    std::optional<std::string> merged;
  };
  const std::vector<Row> rows = {
      {"ours changed", {"a", "a"}, {"b", "b"}, {"a", "a"}, "b"},
      {"theirs changed", {"a", "a"}, {"a", "a"}, {"b", "b"}, "b"},
      {"content before layout", {"a", "a"}, {"a", " a"}, {"b", "b"}, "b"},
      {"layout of both: ours", {"a", "a"}, {"a", " a"}, {"a", "  a"}, " a"},
      {"a comment before layout",
       {"a", "a"},
       {"a", " a"},
       {"a", "a # x"},
       "a # x"},
      {"both changed", {"a", "a"}, {"b", "b"}, {"c", "c"}, std::nullopt},
      {"both alike, other layout", {"a", "a"}, {"b", " b"}, {"b", "b"}, " b"},
      {"both comments",
       {"a", "a"},
       {"a", "a # x"},
       {"a", "a # y"},
       std::nullopt},
      {"content here, a comment there",
       {"a", "a"},
       {"b", "b"},
       {"a", "a # y"},
       std::nullopt},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(MergeText(row.base, row.ours, row.theirs) == row.merged);
    }
  }
  CHECK(MergeBlanks("\n", "\n\n", "\n# x\n") == "\n# x\n");
}

TEST_CASE("TextJoiner keeps pieces from running into each other",
          "[merge_text]") {
  struct Row {
    const char* why;
    std::vector<const char*> pieces;
    const char* joined;
  };
  const std::vector<Row> rows = {
      {"words", {"B", "T"}, "B T"},
      {"numbers", {"1", "-2"}, "1 -2"},
      {"marks", {"T(0.5)", "}"}, "T(0.5)}"},
      {"a comment ends its line", {"B # x", " T"}, "B # x\n T"},
      {"once", {"B # x", "\n  T", " B"}, "B # x\n  T B"},
      {"a comment of an earlier line", {"# x\nB", " T"}, "# x\nB T"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      TextJoiner joiner;
      for (const char* piece : row.pieces) joiner.Append(piece);
      CHECK(std::move(joiner).Text() == row.joined);
    }
  }
}

TEST_CASE("TextJoiner writes lines of their own", "[merge_text]") {
  TextJoiner joiner;
  joiner.Append("a");
  CHECK(joiner.next_line() == 2);
  joiner.AppendLine("<<<");
  CHECK(joiner.next_line() == 3);
  joiner.AppendLine("b\nc");
  CHECK(joiner.next_line() == 5);
  joiner.Append("\n\nd");
  CHECK(std::move(joiner).Text() == "a\n<<<\nb\nc\n\nd");
}

}  // namespace
}  // namespace plsc
