// Every file of tests/programs says on the very line what is wrong there:
// `# expect error[P2001]`, `# expect warning[W3002]`. Nothing else may be.

#include "compiler/programs.h"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <regex>
#include <set>

#include "compiler/compile.h"
#include "grammar/codes.h"

namespace plsc {
namespace {

using testing::ProgramFiles;
using testing::ReadFile;
using testing::ValidProgramFiles;

std::multiset<std::string> Expected(const Source& source) {
  static const std::regex kExpectation(
      R"(# expect (error|warning)\[([A-Z][0-9]{4})\])");
  std::multiset<std::string> expected;
  for (int line = 1; line <= source.line_count(); ++line) {
    const std::string text(source.Line(line));
    for (std::sregex_iterator it(text.begin(), text.end(), kExpectation), end;
         it != end; ++it)
      expected.insert(
          fmt::format("{}: {}[{}]", line, (*it)[1].str(), (*it)[2].str()));
  }
  return expected;
}

std::multiset<std::string> Found(const Source& source) {
  std::multiset<std::string> found;
  const Result<Program> result = Compile(source);
  for (const Diagnostic& diagnostic : result.diagnostics()) {
    const bool is_error = diagnostic.severity == Severity::kError;
    found.insert(
        fmt::format("{}: {}[{}]", source.PositionOf(diagnostic.span.begin).line,
                    is_error ? "error" : "warning", NumberOf(diagnostic.code)));
  }
  return found;
}

TEST_CASE("Programs have the diagnostics that they announce, no others",
          "[programs]") {
  const auto files = ProgramFiles();
  REQUIRE(files.size() >= 60);
  for (const auto& path : files) {
    DYNAMIC_SECTION(path.filename().string()) {
      const Source source(path.filename().string(), ReadFile(path));
      const Result<Program> result = Compile(source);
      INFO(Render(result.diagnostics(), source));
      CHECK(Found(source) == Expected(source));
    }
  }
}

TEST_CASE("Programs meet every code that compiling can give", "[programs]") {
  // P5013 and P5015 have no line to announce them on; screen_test has them.
  // The others are of development, of reading files, of YAML, and of lint.
  // (lint_programs_test of the runtime meets those).
  const std::set<std::string_view> elsewhere = {
      "P5013", "P5015", "P4001", "P4002", "P4003", "P5014", "P5200", "W5200",
      "W2005", "W3003", "W3004", "W3005", "W4001", "W4002", "W4003", "W4004"};
  std::set<std::string> met;
  int announced = 0;
  for (const auto& path : ProgramFiles()) {
    const Source source(path.filename().string(), ReadFile(path));
    announced += Expected(source).empty() ? 0 : 1;
    const Result<Program> result = Compile(source);
    for (const Diagnostic& diagnostic : result.diagnostics())
      met.emplace(NumberOf(diagnostic.code));
  }
  CHECK(announced >= 120);
  for (const CodeInfo& info : DiagnosticCodes()) {
    CAPTURE(info.number);
    if (elsewhere.contains(info.number) || info.number.starts_with("P51"))
      continue;
    CHECK(met.contains(std::string(info.number)));
  }
}

// The text with all fixes of one diagnostic made.
std::string Fixed(const Source& source, std::vector<Fix> fixes) {
  std::sort(fixes.begin(), fixes.end(), [](const Fix& a, const Fix& b) {
    return a.span.begin > b.span.begin;
  });
  std::string text(source.text());
  for (const Fix& fix : fixes)
    text.replace(fix.span.begin, fix.span.end - fix.span.begin,
                 fix.replacement);
  return text;
}

TEST_CASE("A fix repairs what it is offered for", "[programs]") {
  int fixes = 0;
  for (const auto& path : ProgramFiles()) {
    const Source source(path.filename().string(), ReadFile(path));
    const Result<Program> result = Compile(source);
    if (result) continue;
    for (const Diagnostic& diagnostic : result.diagnostics()) {
      if (diagnostic.fixes.empty()) continue;
      ++fixes;
      const Source fixed("fixed", Fixed(source, diagnostic.fixes));
      INFO(Render(diagnostic, source));
      INFO(fixed.text());
      // Errors that the broken item hid may show up, but not this one.
      const auto found = Found(fixed);
      const Position at = source.PositionOf(diagnostic.span.begin);
      CHECK(found.count(fmt::format("{}: error[{}]", at.line,
                                    NumberOf(diagnostic.code))) == 0);
    }
  }
  CHECK(fixes >= 30);
}

TEST_CASE("Valid programs compile without a word", "[programs]") {
  const auto files = ValidProgramFiles();
  REQUIRE(files.size() >= 4);
  for (const auto& path : files) {
    DYNAMIC_SECTION(path.filename().string()) {
      const Result<Program> result =
          Compile(Source(path.string(), ReadFile(path)));
      REQUIRE(result);
      CHECK(result.diagnostics().empty());
    }
  }
}

TEST_CASE("No message speaks of the parser", "[programs]") {
  for (const auto& path : ProgramFiles()) {
    const Source source(path.filename().string(), ReadFile(path));
    const std::string text = Render(Compile(source).diagnostics(), source, 0);
    CAPTURE(text);
    for (const char* word : {"invalid", "pegtl", "grammar::", "P1199"})
      CHECK(text.find(word) == std::string::npos);
  }
}

}  // namespace
}  // namespace plsc
