#include "compiler/format.h"

#include <catch2/catch.hpp>

#include "compiler/print.h"
#include "compiler/programs.h"
#include "compiler/random_genotype.h"

namespace plsc {
namespace {

std::string Formatted(const std::string& text, bool is_compact = false) {
  const Source source("a.pls", text);
  FormatOptions options;
  options.compact = is_compact;
  const Result<std::string> result = Format(source, options);
  INFO(text);
  INFO(Render(result.diagnostics(), source));
  REQUIRE(result);
  return *result;
}

TEST_CASE("Formatting again changes nothing", "[format]") {
  // Format checks this and the meaning itself; here it is checked from
  // outside.
  for (const auto& path : testing::ValidProgramFiles()) {
    for (const bool is_compact : {false, true}) {
      const std::string once = Formatted(testing::ReadFile(path), is_compact);
      CHECK(Formatted(once, is_compact) == once);
    }
  }
}

TEST_CASE("A printed program is formatted already", "[format]") {
  for (std::uint32_t seed = 1; seed <= 200; ++seed) {
    const std::string text = Print(testing::RandomProgram(seed));
    CAPTURE(seed);
    REQUIRE(Formatted(text) == text);
  }
}

TEST_CASE("Compact and back is the printed program", "[format]") {
  for (std::uint32_t seed = 1; seed <= 200; ++seed) {
    const std::string text = Print(testing::RandomProgram(seed));
    CAPTURE(seed);
    REQUIRE(Formatted(Formatted(text, true)) == text);
  }
}

TEST_CASE("A file with errors is not formatted", "[format]") {
  const Result<std::string> result = Format(Source("a", "plsc 1\nrule"));
  REQUIRE_FALSE(result);
  CHECK(result.diagnostics()[0].code == "P1102");
}

TEST_CASE("A comment may stand between any two tokens", "[format]") {
  for (const auto& path : testing::ValidProgramFiles()) {
    // A comment of its own and a new line at every blank, one at a time.
    const std::string text = testing::ReadFile(path);
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] != ' ' && text[i] != '\n') continue;
      for (const char* comment : {" # here\n", "\n\n# here\n\n"}) {
        std::string with = text;
        with.replace(i, 1, comment);
        for (const bool is_compact : {false, true}) {
          FormatOptions options;
          options.compact = is_compact;
          const Source source("a.pls", with);
          const Result<std::string> result = Format(source, options);
          // Within a comment the rest of it becomes code, which may be wrong.
          if (!result) {
            INFO(with);
            INFO(result.diagnostics()[0].message);
            CHECK(result.diagnostics()[0].code != "P5090");
            continue;
          }
          CHECK(result->find("# here") != std::string::npos);
        }
      }
    }
  }
}

}  // namespace
}  // namespace plsc
