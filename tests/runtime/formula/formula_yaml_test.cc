#include "runtime/formula/formula_yaml.h"

#include <catch2/catch.hpp>
#include <string>

namespace plsc {
namespace {

/// What is wrong with `formula:`, as people see it; "" if nothing is.
std::string ErrorsOf(const std::string& text) {
  const Source source("test.yaml", text);
  const YamlFile file(source);
  auto root = file.Root("a test");
  if (root) {
    const auto value = root->Find("formula");
    REQUIRE(value);
    const auto formula = ReadFormula(*value);
    CHECK(formula.has_value() == file.diagnostics().empty());
  }
  return Render(file.diagnostics(), source);
}

TEST_CASE("Formulas of YAML are plain, in quotes or blocks", "[formula]") {
  for (const char* text : {"formula: speed - 0.1 * energy\n", "formula: 3\n",
                           "formula: \"speed > 0 ? speed : 0\"\n",
                           "formula: 'speed > 0 ? speed : 0'\n",
                           "formula: >\n  speed > 0\n  ? speed\n  : 0\n",
                           "formula: |\n  speed\n  - energy\n"})
    CHECK(ErrorsOf(text).empty());
}

TEST_CASE("Errors stand where the formula has them", "[formula]") {
  const std::pair<const char*, const char*> rows[] = {
      {"a: 1\nformula: speed - 0.1 * enegry\n", "test.yaml:2:24"},
      {"formula: \"speed > 0 ? sped : 0\"\n", "test.yaml:1:23"},
      {"formula: >-\n  speed\n  - 2 * sped\n", "test.yaml:3:9"},
      {"formula: \"1 +\"\n", "test.yaml:1:14"},
      // Escapes: the whole.
      {"formula: \"1 \\x2b sped\"\n", "test.yaml:1:10"},
  };
  for (const auto& [text, place] : rows) {
    INFO(text);
    CHECK(ErrorsOf(text).find(place) != std::string::npos);
  }
}

TEST_CASE("What is no text is no formula, and ': ' needs quotes", "[formula]") {
  CHECK(ErrorsOf("formula: [speed]\n").find("expected a formula") !=
        std::string::npos);
  CHECK(ErrorsOf("formula: ''\n").find("found an empty text") !=
        std::string::npos);
  CHECK(ErrorsOf("formula: speed > 0 ? 1 : 2\n").find("stands in quotes") !=
        std::string::npos);
}

}  // namespace
}  // namespace plsc
