#include "runtime/text/unified_diff.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <sstream>
#include <vector>

namespace plsc {
namespace {

std::string Diff(const std::string& a, const std::string& b) {
  return UnifiedDiff(a, b, "a", "b");
}

TEST_CASE("Differences read as those of diff -u", "[diff]") {
  struct Row {
    const char* why;
    const char* from;
    const char* to;
    const char* diff;
  };
  const std::vector<Row> rows = {
      {"equal", "1\n", "1\n", ""},
      {"changed", "1\n2\n3\n", "1\nx\n3\n",
       "--- a\n+++ b\n@@ -1,3 +1,3 @@\n 1\n-2\n+x\n 3\n"},
      {"from nothing", "", "1\n", "--- a\n+++ b\n@@ -0,0 +1 @@\n+1\n"},
      {"to nothing", "1\n2\n", "", "--- a\n+++ b\n@@ -1,2 +0,0 @@\n-1\n-2\n"},
      {"no end of line", "1", "1\n",
       "--- a\n+++ b\n@@ -1 +1 @@\n-1\n\\ No newline at end of file\n+1\n"},
      {"three lines around", "1\n2\n3\n4\n5\n6\n7\n8\n9\n",
       "1\n2\n3\n4\n6\n7\n8\n9\n",
       "--- a\n+++ b\n@@ -2,7 +2,6 @@\n 2\n 3\n 4\n-5\n 6\n 7\n 8\n"},
      {"far apart: two hunks", "a\n1\n2\n3\n4\n5\n6\n7\nb\n",
       "1\n2\n3\n4\n5\n6\n7\n",
       "--- a\n+++ b\n@@ -1,4 +1,3 @@\n-a\n 1\n 2\n 3\n@@ -6,4 +5,3 @@\n 5\n "
       "6\n 7\n-b\n"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(Diff(row.from, row.to) == row.diff);
    }
  }
}

std::vector<std::string> Lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// The length of the longest common subsequence, by the textbook's table.
std::size_t CommonLines(const std::vector<std::string>& a,
                        const std::vector<std::string>& b) {
  std::vector<std::vector<std::size_t>> best(
      a.size() + 1, std::vector<std::size_t>(b.size() + 1, 0));
  for (std::size_t i = a.size(); i-- > 0;)
    for (std::size_t j = b.size(); j-- > 0;)
      best[i][j] = a[i] == b[j] ? best[i + 1][j + 1] + 1
                                : std::max(best[i + 1][j], best[i][j + 1]);
  return best[0][0];
}

TEST_CASE("Random texts: the difference is right and the shortest", "[diff]") {
  std::mt19937 random(3);  // NOLINT(bugprone-random-generator-seed)
  for (int trial = 0; trial < 2000; ++trial) {
    const auto text = [&] {
      std::string made;
      for (auto lines = random() % 14; lines > 0; --lines)
        made += std::string(1, static_cast<char>('p' + random() % 4)) + "\n";
      return made;
    };
    const std::string from = text();
    const std::string to = text();
    const auto a = Lines(from);
    const auto b = Lines(to);
    INFO(from << "---\n" << to);
    // Apply the difference: kept and deleted lines are the old text's.
    std::vector<std::string> made;
    std::size_t at = 0;
    std::size_t changes = 0;
    std::vector<std::string> lines = Lines(Diff(from, to));
    for (std::size_t i = 2; i < lines.size(); ++i) {
      const std::string& line = lines[i];
      if (line.starts_with("@@")) {
        auto first = std::stoul(line.substr(4));
        const bool is_empty = line.find(",0 +") != std::string::npos;
        if (!is_empty) --first;
        while (at < first) made.push_back(a[at++]);
        continue;
      }
      if (line[0] != '+') {
        REQUIRE(a[at] == line.substr(1));
        ++at;
      }
      if (line[0] != '-') made.push_back(line.substr(1));
      if (line[0] != ' ') ++changes;
    }
    while (at < a.size()) made.push_back(a[at++]);
    REQUIRE(made == b);
    REQUIRE(changes == a.size() + b.size() - 2 * CommonLines(a, b));
  }
}

TEST_CASE("Texts that share nothing differ as a whole", "[diff]") {
  std::string a;
  std::string b;
  for (int i = 0; i < 3000; ++i) {
    a += "a" + std::to_string(i) + "\n";
    b += "b" + std::to_string(i) + "\n";
  }
  const auto lines = Lines(Diff("same\n" + a, "same\n" + b));
  REQUIRE(lines.size() == 3 + 1 + 6000);
  CHECK(lines[2] == "@@ -1,3001 +1,3001 @@");
}

TEST_CASE("Changed lines are those that make one text of the other",
          "[unified_diff]") {
  const std::vector<std::string> texts = {
      "",       "a\n",     "a\nb\nc\n", "a\nx\nc\n",
      "b\nc\n", "a\nb\nc", "c\nb\na\n", "a\nb\nb\nb\nc\nd\n"};
  for (const std::string& from : texts) {
    for (const std::string& to : texts) {
      CAPTURE(from, to);
      std::string made;
      std::size_t copied = 0;
      for (const ChangedLines& one : LineChanges(from, to)) {
        CHECK(std::count(from.begin(),
                         from.begin() + static_cast<std::ptrdiff_t>(one.begin),
                         '\n') == static_cast<std::ptrdiff_t>(one.first_line));
        CHECK(one.end_line - one.first_line <= one.end - one.begin);
        made += from.substr(copied, one.begin - copied) + one.replacement;
        copied = one.end;
      }
      CHECK(made + from.substr(copied) == to);
    }
  }
}

}  // namespace
}  // namespace plsc
