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
  CHECK(result.diagnostics()[0].code == Code::kMissingName);
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
            CHECK(result.diagnostics()[0].code != Code::kFormatterDefect);
            continue;
          }
          CHECK(result->find("# here") != std::string::npos);
        }
      }
    }
  }
}

const std::string kFormatHead = "plsc 1\n\nalphabet plasticoding 1\n\n";

TEST_CASE("Paragraphs of a production stay", "[format]") {
  struct Row {
    const char* why;
    std::string written;
    std::string formatted;
    std::string compact;
  };
  const std::vector<Row> rows = {
      {"an empty line", "rule C -> { C B\n\nadd_left B }",
       "rule C -> {\n  C\n  B\n\n  add_left\n  B\n}\n",
       "rule C -> {\n  C\n  B\n\n  add_left B\n}\n"},
      {"several become one", "rule C -> { C\n\n \n\n B }",
       "rule C -> {\n  C\n\n  B\n}\n", "rule C -> {\n  C\n\n  B\n}\n"},
      {"none at the braces", "rule C -> {\n\n C B\n\n}",
       "rule C -> {\n  C\n  B\n}\n", "rule C -> { C B }\n"},
      {"around a comment", "rule C -> { C # core\n\n# left\n\nB\n\n# end\n}",
       "rule C -> {\n  C  # core\n\n  # left\n\n  B\n\n  # end\n}\n",
       "rule C -> {\n  C  # core\n\n  # left\n\n  B\n\n  # end\n}\n"},
      {"not within a symbol", "rule B -> { B T(\n\n# w\n0.5) }",
       "rule B -> {\n  B\n  # w\n  T(0.5)\n}\n",
       "rule B -> {\n  B\n  # w\n  T(0.5)\n}\n"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(Formatted(kFormatHead + row.written) ==
            kFormatHead + row.formatted);
      CHECK(Formatted(kFormatHead + row.written, true) ==
            kFormatHead + row.compact);
    }
  }
}

TEST_CASE("Lines end as they did", "[format]") {
  const std::string text =
      kFormatHead + "# a\nrule C -> {\n  C  # b\n\n  B\n}\n";
  std::string windows;
  for (const char c : text) windows += c == '\n' ? "\r\n" : std::string(1, c);
  CHECK(Formatted(text) == text);
  CHECK(Formatted(windows) == windows);
  // The first line counts.
  CHECK(Formatted("plsc 1\r\n" + text.substr(7)) == windows);
  CHECK(Formatted("plsc 1\n" + windows.substr(8)) == text);
}

}  // namespace
}  // namespace plsc
