#include "runtime/cli/testing/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "grammar/enum_names.h"
#include "runtime/text/json_dump.h"

namespace plsc::cli {

namespace {

using Json = nlohmann::ordered_json;

// Differences of one test that the text shows; JSON and JUnit have all. After
// twenty it is another robot, and the next test should stay in sight.
constexpr std::size_t kShownDifferences = 20;

std::string Indented(const std::string& lines) {
  std::string text;
  std::size_t begin = 0;
  while (begin < lines.size()) {
    const std::size_t end = std::min(lines.find('\n', begin), lines.size());
    text += "  " + lines.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  return text;
}

std::string CaseText(const TestPaths& paths, const TestCase& test) {
  std::string name = paths.genotype;
  if (!test.genotype.empty()) name += "#" + test.genotype;
  if (!test.environment.empty()) name += " in " + test.environment;
  switch (test.verdict) {
    case Verdict::kSame:
      return "";
    case Verdict::kUpdated:
      return fmt::format("{}: updated {}\n", name, paths.golden);
    case Verdict::kUnrecorded:
    case Verdict::kError:
      return name + ":\n" + Indented(test.message);
    case Verdict::kDiffers:
      break;
  }
  // A diagnostic says where it is.
  if (!test.test.empty()) return test.message;
  std::string text = fmt::format("{} differs from {}:\n", name, paths.golden);
  const std::size_t shown =
      std::min(test.differences.size(), kShownDifferences);
  for (std::size_t i = 0; i < shown; ++i)
    text += "  " + Describe(test.differences[i]) + "\n";
  if (shown < test.differences.size())
    text += fmt::format("  and {} more\n", test.differences.size() - shown);
  return text;
}

std::string_view VerdictName(Verdict verdict) {
  constexpr EnumNames<Verdict, 5> kNames{{{Verdict::kSame, "same"},
                                          {Verdict::kDiffers, "differs"},
                                          {Verdict::kUnrecorded, "unrecorded"},
                                          {Verdict::kError, "error"},
                                          {Verdict::kUpdated, "updated"}}};
  return NameIn(kNames, verdict);
}

Json DifferencesJson(const std::vector<Difference>& differences) {
  Json list = Json::array();
  for (const Difference& difference : differences) {
    Json json{{"kind", KindName(difference.kind)}, {"what", difference.what}};
    if (difference.kind == DifferenceKind::kMoved ||
        difference.kind == DifferenceKind::kChanged) {
      json["expected"] = difference.expected;
      json["found"] = difference.found;
    }
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace

void Count(const TestedFile& tested, TestTotals& totals) {
  ++totals.files;
  for (const TestCase& test : tested.cases) {
    ++totals.tests;
    totals.same += test.verdict == Verdict::kSame ? 1 : 0;
    totals.differ += test.verdict == Verdict::kDiffers ? 1 : 0;
    const bool is_recordable = test.verdict == Verdict::kDiffers ||
                               test.verdict == Verdict::kUnrecorded;
    totals.recordable += is_recordable && test.test.empty() ? 1 : 0;
    totals.unrecorded += test.verdict == Verdict::kUnrecorded ? 1 : 0;
    totals.errors += test.verdict == Verdict::kError ? 1 : 0;
    totals.updated += test.verdict == Verdict::kUpdated ? 1 : 0;
  }
}

std::string TestText(const TestedFile& tested) {
  std::string text;
  for (const TestCase& test : tested.cases)
    text += CaseText(tested.paths, test);
  return text;
}

std::string TestSummary(const TestTotals& totals) {
  std::string text =
      fmt::format("{} {} of {} {}: {} as expected", totals.tests,
                  totals.tests == 1 ? "test" : "tests", totals.files,
                  totals.files == 1 ? "file" : "files", totals.same);
  if (totals.updated > 0) text += fmt::format(", {} updated", totals.updated);
  if (totals.differ > 0)
    text += fmt::format(", {} differ{}", totals.differ,
                        totals.differ == 1 ? "s" : "");
  if (totals.unrecorded > 0)
    text += fmt::format(", {} not recorded", totals.unrecorded);
  if (totals.errors > 0)
    text += fmt::format(", {} error{}", totals.errors,
                        totals.errors == 1 ? "" : "s");
  text += "\n";
  if (totals.recordable > 0)
    text += "`plsc test --update` records what was found as expected\n";
  return text;
}

std::string TestJson(const TestedFile& tested) {
  std::string lines;
  for (const TestCase& test : tested.cases) {
    const Json json{
        {"file", tested.paths.genotype},
        {"golden", tested.paths.golden},
        {"genotype",
         test.genotype.empty() ? Json(nullptr) : Json(test.genotype)},
        {"test", test.test.empty() ? Json(nullptr) : Json(test.test)},
        {"environment",
         test.environment.empty() ? Json(nullptr) : Json(test.environment)},
        {"verdict", VerdictName(test.verdict)},
        {"differences", DifferencesJson(test.differences)},
        {"message", test.message}};
    // Names of files are bytes; what is no UTF-8 in them becomes U+FFFD.
    lines += DumpJson(json) + "\n";
  }
  return lines;
}

}  // namespace plsc::cli
