#include "runtime/cli/testing/report.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

namespace plsc {
namespace {

using cli::Verdict;

cli::TestedFile Sample() {
  return {{"r/g.pls", "r/g.golden.json"},
          {{"flat", Verdict::kSame, {}, ""},
           {"tilted",
            Verdict::kDiffers,
            {{DifferenceKind::kAdded, "module 7 (A1 at x=1,y=0)", "", ""},
             {DifferenceKind::kChanged, "length of the string", "4", "5"}},
            ""},
           {"hot=True", Verdict::kUnrecorded, {}, "nothing yet\n"},
           {"", Verdict::kError, {}, "error: one\n  two\n"},
           {"cold", Verdict::kUpdated, {}, ""}}};
}

TEST_CASE("the text shows what failed and where", "[test_report]") {
  CHECK(cli::TestText(Sample()) ==
        "r/g.pls in tilted differs from r/g.golden.json:\n"
        "  module 7 (A1 at x=1,y=0) added\n"
        "  length of the string: expected 4, found 5\n"
        "r/g.pls in hot=True:\n"
        "  nothing yet\n"
        "r/g.pls:\n"
        "  error: one\n"
        "    two\n"
        "r/g.pls in cold: updated r/g.golden.json\n");
}

TEST_CASE("long lists of differences are cut in the text only",
          "[test_report]") {
  cli::TestedFile tested{{"g.pls", "g"}, {{"a", Verdict::kDiffers, {}, ""}}};
  for (int i = 0; i < 25; ++i)
    tested.cases[0].differences.push_back(
        {DifferenceKind::kMissing, "edge " + std::to_string(i), "", ""});
  const std::string text = cli::TestText(tested);
  CHECK(text.find("edge 19 missing\n  and 5 more\n") != std::string::npos);
  CHECK(nlohmann::json::parse(cli::TestJson(tested))["differences"].size() ==
        25);
}

TEST_CASE("the summary counts", "[test_report]") {
  cli::TestTotals totals;
  CHECK(!totals.has_failures());
  cli::Count(Sample(), totals);
  CHECK(totals.has_failures());
  CHECK(cli::TestSummary(totals) ==
        "5 tests of 1 file: 1 as expected, 1 updated, 1 differs, 1 not "
        "recorded, 1 error\n"
        "`plsc test --update` records what was found as expected\n");
}

TEST_CASE("JSON has a line a test", "[test_report]") {
  std::istringstream lines(cli::TestJson(Sample()));
  std::vector<nlohmann::json> tests;
  for (std::string line; std::getline(lines, line);)
    tests.push_back(nlohmann::json::parse(line));
  REQUIRE(tests.size() == 5);
  CHECK(tests[0]["verdict"] == "same");
  CHECK(tests[1]["file"] == "r/g.pls");
  CHECK(tests[1]["environment"] == "tilted");
  CHECK(tests[1]["differences"][1] ==
        nlohmann::json{{"kind", "changed"},
                       {"what", "length of the string"},
                       {"expected", "4"},
                       {"found", "5"}});
  CHECK(tests[1]["differences"][0].size() == 2);
  CHECK(tests[3]["environment"].is_null());
  CHECK(tests[3]["message"] == "error: one\n  two\n");
}

TEST_CASE("JSON stays JSON with names that are no text", "[test_report]") {
  cli::TestedFile tested = Sample();
  tested.paths.genotype = "a\xff\"\n.pls";
  std::istringstream lines(cli::TestJson(tested));
  std::string line;
  std::getline(lines, line);
  CHECK(nlohmann::json::parse(line)["file"] == "a\xEF\xBF\xBD\"\n.pls");
}

}  // namespace
}  // namespace plsc
