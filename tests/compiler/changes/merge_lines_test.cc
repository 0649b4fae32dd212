#include "compiler/changes/merge_lines.h"

#include <catch2/catch.hpp>
#include <string>

#include "tests/compiler/changes/merge_rows.h"

namespace plsc {
namespace {

TEST_CASE("Lines that one side changed are taken", "[merge]") {
  const std::vector<test::MergeRow> rows = {
      {"nothing", "", "", "", ""},
      {"ours", "1\n2\n3\n", "1\nx\n3\n", "1\n2\n3\n", "1\nx\n3\n"},
      {"both, apart", "1\n2\n3\n", "x\n2\n3\n", "1\n2\ny\n", "x\n2\ny\n"},
      {"both alike", "1\n2\n", "1\nx\n", "1\nx\n", "1\nx\n"},
      {"deleted", "1\n2\n3\n", "2\n3\n", "1\n2\n", "2\n"},
      {"no line end", "1\n2", "0\n1\n2", "1\n2", "0\n1\n2"},
      {"both added alike", "", "1\n", "1\n", "1\n"},
  };
  test::CheckMerges(rows,
                    [](const char* base, const char* ours, const char* theirs) {
                      const MergedFile merged = MergeLines(base, ours, theirs);
                      CHECK(merged.conflicts.empty());
                      return merged.text;
                    });
}

TEST_CASE("Lines that both sides changed get git's markers", "[merge]") {
  MergeLabels labels;
  labels.ours = "main";
  labels.marker_size = 3;
  const MergedFile merged =
      MergeLines("1\n2\n3\n", "1\nx\n3\n", "1\ny\n3\n", labels);
  CHECK(merged.text == "1\n<<< main\nx\n||| base\n2\n===\ny\n>>> theirs\n3\n");
  REQUIRE(merged.conflicts.size() == 1);
  CHECK(merged.conflicts[0].line == 2);
  CHECK(merged.conflicts[0].message ==
        "changed in different ways in main and theirs");
}

TEST_CASE("Markers stand on lines of their own, with the file's line ends",
          "[merge]") {
  CHECK(MergeLines("1", "x", "y").text ==
        "<<<<<<< ours\nx\n||||||| base\n1\n=======\ny\n>>>>>>> theirs\n");
  CHECK(MergeLines("a\r\n1\r\n", "a\r\nx\r\n", "a\r\ny\r\n").text ==
        "a\r\n<<<<<<< ours\r\nx\r\n||||||| base\r\n1\r\n=======\r\ny\r\n"
        ">>>>>>> theirs\r\n");
}

}  // namespace
}  // namespace plsc
