#include "runtime/cli/testing/junit.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

using cli::JunitText;
using cli::Verdict;

TEST_CASE("JunitText makes any bytes text of XML", "[test_junit]") {
  struct Row {
    const char* why;
    std::string bytes;
    std::string text;
  };
  const std::string bad = "\xEF\xBF\xBD";
  const std::vector<Row> rows = {
      {"plain", "gecko-1.pls", "gecko-1.pls"},
      {"marks", "<a & \"b\">", "&lt;a &amp; &quot;b&quot;&gt;"},
      {"blanks", "a\tb\nc\rd e", "a&#9;b&#10;c&#13;d e"},
      {"end of a CDATA section", "]]>", "]]&gt;"},
      {"control characters", std::string("\x00\x1b[2J", 5), bad + bad + "[2J"},
      {"not UTF-8", "a\xff\xc3", "a" + bad + bad},
      {"a surrogate", "\xED\xA0\x80", bad + bad + bad},
      {"no characters of XML", "\xEF\xBF\xBE|\xEF\xBF\xBF", bad + "|" + bad},
      {"other languages", "\xC3\xA9\xF0\x9F\xA6\x8E",
       "\xC3\xA9\xF0\x9F\xA6\x8E"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      // How many replacements a broken sequence gets is the library's matter.
      if (std::string(row.why) == "a surrogate")
        CHECK(JunitText(row.bytes).find('\xED') == std::string::npos);
      else
        CHECK(JunitText(row.bytes) == row.text);
    }
  }
}

TEST_CASE("JUnit has a suite a genotype and a case an environment",
          "[test_junit]") {
  const cli::TestedFile tested{
      {"a&b.pls", "a&b.golden.json"},
      {{"flat", Verdict::kSame, {}, ""},
       {"tilted",
        Verdict::kDiffers,
        {{DifferenceKind::kChanged, "edge node3->node1", "1", "<2>"}},
        ""},
       {"hot", Verdict::kUnrecorded, {}, "not yet\n"},
       {"", Verdict::kError, {}, "error: no\nmore\n"}}};
  cli::TestTotals totals;
  cli::Count(tested, totals);
  CHECK(cli::JunitDocument(totals, cli::JunitSuite(tested)) ==
        R"xml(<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="plsc test" tests="4" failures="2" errors="1">
  <testsuite name="a&amp;b.pls" tests="4" failures="2" errors="1">
    <testcase classname="a&amp;b.pls" name="flat"/>
    <testcase classname="a&amp;b.pls" name="tilted">
      <failure message="1 difference from a&amp;b.golden.json">edge node3-&gt;node1: expected 1, found &lt;2&gt;&#10;</failure>
    </testcase>
    <testcase classname="a&amp;b.pls" name="hot">
      <failure message="no expectation">not yet&#10;</failure>
    </testcase>
    <testcase classname="a&amp;b.pls" name="(the file)">
      <error message="error: no">error: no&#10;more&#10;</error>
    </testcase>
  </testsuite>
</testsuites>
)xml");
}

}  // namespace
}  // namespace plsc
