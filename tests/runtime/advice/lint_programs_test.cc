// Every file of tests/programs/lint says on the very line what all lints
// together find there: `# expect warning[W3004]`. Nothing else may be.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "grammar/codes.h"
#include "runtime/advice/lint.h"

namespace plsc {
namespace {

std::multiset<std::string> Expected(const Source& source) {
  static const std::regex kExpectation(R"(# expect warning\[(W[0-9]{4})\])");
  std::multiset<std::string> expected;
  for (int line = 1; line <= source.line_count(); ++line) {
    const std::string text(source.Line(line));
    for (std::sregex_iterator it(text.begin(), text.end(), kExpectation), end;
         it != end; ++it)
      expected.insert(fmt::format("{}: {}", line, (*it)[1].str()));
  }
  return expected;
}

TEST_CASE("Lints find what programs announce, and nothing else", "[lint]") {
  const auto folder =
      std::filesystem::path(PLSC_SOURCE_DIR) / "tests" / "programs" / "lint";
  std::set<std::string> met;
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    ++files;
    std::ifstream file(entry.path(), std::ios::binary);
    const Source source(entry.path().filename().string(),
                        {std::istreambuf_iterator<char>(file), {}});
    const Result<MappedProgram> compiled = CompileWithMap(source);
    INFO(Render(compiled.diagnostics(), source));
    REQUIRE(compiled);
    std::vector<Diagnostic> all = Lint({&*compiled, 1}, source);
    INFO(Render(all, source));
    all.insert(all.end(), compiled.diagnostics().begin(),
               compiled.diagnostics().end());
    std::multiset<std::string> found;
    for (const Diagnostic& warning : all) {
      CHECK(warning.severity == Severity::kWarning);
      CHECK(FindCode(NumberOf(warning.code)));
      met.emplace(NumberOf(warning.code));
      found.insert(fmt::format("{}: {}",
                               source.PositionOf(warning.span.begin).line,
                               NumberOf(warning.code)));
    }
    CHECK(found == Expected(source));
  }
  CHECK(files >= 12);
  CHECK(met == std::set<std::string>{"W1001", "W3002", "W3003", "W3004",
                                     "W3005", "W4001", "W4002", "W4003",
                                     "W4004"});
}

}  // namespace
}  // namespace plsc
