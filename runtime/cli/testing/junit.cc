#include "runtime/cli/testing/junit.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "runtime/text/xml.h"

namespace plsc::cli {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

// The JSON library knows which bytes are UTF-8.
std::string ValidUtf8(std::string_view bytes) {
  using nlohmann::json;
  return json::parse(
             json(bytes).dump(-1, ' ', false, json::error_handler_t::replace))
      .get<std::string>();
}

// Empty: the character stays as it is. Blanks but the space are numbered,
// since readers turn them into spaces in attributes.
std::string Escape(char c) {
  if (c == '\t' || c == '\n' || c == '\r')
    return fmt::format("&#{};", static_cast<int>(c));
  // XML 1.0, production 2: no other control characters, not even numbered.
  if (static_cast<unsigned char>(c) < 0x20) return std::string(kReplacement);
  return std::string(XmlEntity(c));
}

std::string DifferenceLines(const TestCase& test) {
  std::string lines;
  for (const Difference& difference : test.differences)
    lines += Describe(difference) + "\n";
  return lines;
}

std::string CaseXml(const TestedFile& tested, const TestCase& test) {
  std::string name = test.environment.empty() ? "(the file)" : test.environment;
  if (!test.test.empty()) name = "test " + test.test;
  if (!test.genotype.empty()) name = test.genotype + ": " + name;
  const std::string open =
      fmt::format("    <testcase classname=\"{}\" name=\"{}\"",
                  JunitText(tested.paths.genotype), JunitText(name));
  const auto with = [&](const char* element, const std::string& headline,
                        const std::string& text) {
    return fmt::format(
        "{}>\n      <{} message=\"{}\">{}</{}>\n    </testcase>\n", open,
        element, JunitText(headline), JunitText(text), element);
  };
  switch (test.verdict) {
    case Verdict::kSame:
    case Verdict::kUpdated:
      return open + "/>\n";
    case Verdict::kDiffers:
      if (!test.test.empty())
        return with("failure", "the expectation of the file does not come out",
                    test.message);
      return with("failure",
                  fmt::format("{} {} from {}", test.differences.size(),
                              test.differences.size() == 1 ? "difference"
                                                           : "differences",
                              tested.paths.golden),
                  DifferenceLines(test));
    case Verdict::kUnrecorded:
      return with("failure", "no expectation", test.message);
    case Verdict::kError:
      return with("error", test.message.substr(0, test.message.find('\n')),
                  test.message);
  }
  return "";
}

}  // namespace

std::string JunitText(std::string_view bytes) {
  const std::string valid = ValidUtf8(bytes);
  std::string text;
  for (std::size_t i = 0; i < valid.size(); ++i) {
    const std::string_view three = std::string_view(valid).substr(i, 3);
    // U+FFFE and U+FFFF are no characters of XML.
    if (three == "\xEF\xBF\xBE" || three == "\xEF\xBF\xBF") {
      text += kReplacement;
      i += 2;
      continue;
    }
    const std::string escaped = Escape(valid[i]);
    if (escaped.empty())
      text += valid[i];
    else
      text += escaped;
  }
  return text;
}

std::string JunitSuite(const TestedFile& tested) {
  TestTotals totals;
  Count(tested, totals);
  std::string text = fmt::format(
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n",
      JunitText(tested.paths.genotype), totals.tests,
      totals.differ + totals.unrecorded, totals.errors);
  for (const TestCase& test : tested.cases) text += CaseXml(tested, test);
  return text + "  </testsuite>\n";
}

std::string JunitDocument(const TestTotals& totals, std::string_view suites) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites name=\"plsc test\" tests=\"{}\" failures=\"{}\" "
      "errors=\"{}\">\n{}</testsuites>\n",
      totals.tests, totals.differ + totals.unrecorded, totals.errors, suites);
}

}  // namespace plsc::cli
