#include "compiler/apply_fixes.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "compiler/programs.h"

namespace plsc {
namespace {

constexpr const char* kHead =
    "plsc 1\nalphabet plasticoding 1\nsense inclined: bool\n";

std::ptrdiff_t Errors(const std::vector<Diagnostic>& diagnostics) {
  return std::count_if(
      diagnostics.begin(), diagnostics.end(),
      [](const Diagnostic& d) { return d.severity == Severity::kError; });
}

Diagnostic WithFixes(std::vector<Fix> fixes) {
  Diagnostic diagnostic(Code::kUnknownItem, {}, "");
  diagnostic.fixes = std::move(fixes);
  return diagnostic;
}

TEST_CASE("Fixes that do not touch are made together", "[apply_fixes]") {
  struct Row {
    const char* why;
    std::vector<Diagnostic> diagnostics;
    const char* expected;
    std::size_t made;
  };
  const std::vector<Row> rows = {
      {"none", {}, "abcdef", 0},
      {"a replacement", {WithFixes({{{1, 3}, "X"}})}, "aXdef", 1},
      {"an insertion", {WithFixes({{{6, 6}, "!"}})}, "abcdef!", 1},
      {"a deletion", {WithFixes({{{0, 2}, ""}})}, "cdef", 1},
      {"two that touch at a border",
       {WithFixes({{{2, 4}, "Y"}}), WithFixes({{{0, 2}, "X"}})},
       "XYef",
       2},
      {"of two that overlap, the first in the text",
       {WithFixes({{{2, 4}, "Y"}}), WithFixes({{{1, 3}, "X"}})},
       "aXdef",
       1},
      {"of two insertions at one place, one",
       {WithFixes({{{3, 3}, "1"}}), WithFixes({{{3, 3}, "2"}})},
       "abc1def",
       1},
      {"changes of one diagnostic all or none",
       {WithFixes({{{0, 1}, "X"}}), WithFixes({{{0, 1}, "Y"}, {{4, 5}, "Z"}})},
       "Xbcdef",
       1},
      {"a place that the text does not have",
       {WithFixes({{{5, 9}, "X"}})},
       "abcdef",
       0},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const MendedText mended =
          ApplyFixes(Source("a", "abcdef"), row.diagnostics);
      CHECK(mended.text == row.expected);
      CHECK(mended.made.size() == row.made);
    }
  }
}

TEST_CASE("Texts are mended until nothing more can be", "[apply_fixes]") {
  struct Row {
    const char* why;
    const char* text;
    const char* expected;
    std::ptrdiff_t remaining;
  };
  const std::vector<Row> rows = {
      {"a right text stays", "rule B -> { B }\n", "rule B -> { B }\n", 0},
      {"a slip of the pen", "rule B -> { add_lef B }\n",
       "rule B -> { add_left B }\n", 0},
      {"several in one file", "rule B -> { add_lef B }\nrule T -> { T(.5) }\n",
       "rule B -> { add_left B }\nrule T -> { T(0.5) }\n", 0},
      {"what an error hid is mended next",
       "rule B -> { add_lef, T(+0.5), B }\n",
       "rule B -> { add_left T(0.5) B }\n", 0},
      {"one diagnostic with several changes",
       "rule C -> if inclined == true && inclined == false then { C }\n",
       "rule C -> if inclined = True and inclined = False then { C }\n", 0},
      {"what cannot be mended is left", "rule B -> { wheel add_lef T(5) }\n",
       "rule B -> { wheel add_left T(5) }\n", 2},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const MendedText mended =
          MendText(Source("a", std::string(kHead) + row.text));
      CHECK(mended.text == std::string(kHead) + row.expected);
      CHECK(Errors(mended.remaining) == row.remaining);
      CHECK(mended.made.empty() ==
            (mended.text == kHead + std::string(row.text)));
    }
  }
}

TEST_CASE("What was mended is told with its place", "[apply_fixes]") {
  const MendedText mended =
      MendText(Source("a", std::string(kHead) + "rule B -> { add_lef B }\n"));
  REQUIRE(mended.made.size() == 1);
  CHECK(mended.made[0].position.line == 4);
  CHECK(mended.made[0].position.column == 13);
  CHECK(mended.made[0].code == Code::kUnknownSymbol);
  CHECK(mended.made[0].removed == "add_lef");
  CHECK(mended.made[0].replacement == "add_left");
}

TEST_CASE("No text has more errors than before it was mended",
          "[apply_fixes]") {
  int fixed = 0;
  for (const auto& path : testing::ProgramFiles()) {
    CAPTURE(path.string());
    const Source source("a", testing::ReadFile(path));
    const auto before = CompileAll(source);
    const MendedText mended = MendText(source);
    INFO(mended.text);
    CHECK(Errors(mended.remaining) <= Errors(before.diagnostics()));
    const auto after = CompileAll(Source("a", mended.text));
    CHECK(Errors(after.diagnostics()) == Errors(mended.remaining));
    if (mended.made.empty()) CHECK(mended.text == source.text());
    // Mending again finds nothing: it had gone on as long as it could.
    CHECK(MendText(Source("a", mended.text)).text == mended.text);
    if (!before && after) ++fixed;
  }
  CHECK(fixed >= 20);
}

TEST_CASE("Names of the authors' program are mended, and what to know is told",
          "[apply_fixes]") {
  const Source source("a",
                      "plsc 1\nalphabet plasticoding 1\n"
                      "rule AJ1 -> { addl AJ2(0.5, 2, 3, 4) ST(1) movef }\n");
  const MendedText mended = MendText(source);
  CHECK(mended.remaining.empty());
  CHECK(mended.text ==
        "plsc 1\nalphabet plasticoding 1\n"
        "rule A2 -> { add_left A1(0.5, 2, 3, 4) T(1) move_front }\n");
  REQUIRE(mended.made.size() == 5);
  CHECK(mended.made[0].note.find("ordered w, a, p, o") != std::string::npos);
}

TEST_CASE("What is inserted ends its lines as the text does", "[apply_fixes]") {
  const Source source("a", "plsc 1\r\nrule C -> { C }\r\n");
  CHECK(MendText(source).text ==
        "plsc 1\r\nalphabet plasticoding 1\r\nrule C -> { C }\r\n");
}

// Not timed; comparing each change with all others would take hours.
TEST_CASE("A million changes are made", "[apply_fixes]") {
  std::string text;
  for (int i = 0; i < 1'000'000; ++i) text += "a\n";
  std::vector<Diagnostic> diagnostics(1000, WithFixes({}));
  for (std::size_t i = 0; i < diagnostics.size(); ++i)
    for (std::size_t k = 0; k < 1000; ++k) {
      const auto at = static_cast<std::uint32_t>(2 * (1000 * k + i));
      diagnostics[i].fixes.push_back({{at, at + 1}, "b"});
    }
  const MendedText mended = ApplyFixes(Source("a", text), diagnostics);
  CHECK(mended.made.size() == 1'000'000);
  CHECK(mended.text.substr(0, 6) == "b\nb\nb\n");
}

}  // namespace
}  // namespace plsc
