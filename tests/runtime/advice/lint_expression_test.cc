#include "runtime/advice/lint_expression.h"

#include <catch2/catch.hpp>
#include <random>
#include <set>

#include "runtime/develop/trace.h"
#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

std::vector<Diagnostic> Linted(const Source& source) {
  const auto compiled = CompileWithMap(source);
  INFO(Render(compiled.diagnostics(), source));
  REQUIRE(compiled);
  const StateSpace space(compiled->program.genotype);
  const auto regimes =
      FindRegimes(ClausesOf(compiled->program.genotype), space);
  REQUIRE(regimes);
  return LintExpression(*compiled, space, *regimes, {0, 4});
}

TEST_CASE("A symbol that one environment expresses is fine", "[lint]") {
  const Source source(
      "a",
      "plsc 1 alphabet plasticoding 1 sense hot: bool iterations 1\n"
      "rule C -> if hot = True then { C add_front }\n"
      "rule C -> { C B }\n");
  CHECK(Linted(source).empty());
}

TEST_CASE("The reason is told", "[lint]") {
  const Source source("a",
                      "plsc 1 alphabet plasticoding 1 iterations 1\n"
                      "rule C -> { C B }\n");
  const auto found = Linted(source);
  REQUIRE(found.size() == 1);
  CHECK(found[0].message == "this 'B' is expressed in no environment");
  CHECK(found[0].label == InfoOf(Effect::kNoSlot).text);
  CHECK(source.text().substr(found[0].span.begin, 1) == "B");
}

TEST_CASE("Without rewriting no rule does anything", "[lint]") {
  const Source source("a",
                      "plsc 1 alphabet plasticoding 1 iterations 0\n"
                      "rule C -> { C add_left B }\n");
  const auto found = Linted(source);
  REQUIRE(found.size() == 1);
  CHECK(found[0].message == "this rule for 'C' rewrites nothing");
}

TEST_CASE("Too much to develop is said, not tried", "[lint]") {
  std::string text = "plsc 1 alphabet plasticoding 1 iterations 19\n";
  std::string rules = "rule C -> { C B }\nrule B -> { B B }\n";
  for (int i = 0; i < 5; ++i) {
    const std::string state = "s" + std::to_string(i);
    text += "sense " + state + ": bool\n";
    rules += "rule T -> if " + state + " = True then { T(1) }\n";
  }
  const auto found = Linted(Source("a", text + rules));
  REQUIRE(found.size() == 1);
  CHECK(found[0].code == Code::kUnchecked);
}

// The oracle: development with its history in every environment, not only one
// a regime, and calls found by walking every insertion.
TEST_CASE("Random robots: dead symbols are those that no history uses",
          "[lint]") {
  std::mt19937 random(5);  // NOLINT(bugprone-random-generator-seed)
  const std::vector<std::string> symbols = {"B",
                                            "A1(0.5, 2, 3, 1)",
                                            "T(0.5)",
                                            "add_left",
                                            "add_front",
                                            "add_right",
                                            "move_back",
                                            "move_front",
                                            "move_left",
                                            "loop(0.1)",
                                            "add_edge(0.2)",
                                            "mutate_per(0.1)",
                                            "move_ref_I(1, 1)"};
  const std::vector<std::string> clauses = {
      "", "if p = True then", "if p = False then", "if q = True then",
      "if p = True and q = False then"};
  int dead_symbols = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::string text =
        "plsc 1 alphabet plasticoding 1 sense p: bool sense q: bool "
        "iterations " +
        std::to_string(random() % 4) + "\n";
    for (const char* head : {"C", "C", "B", "B", "T"}) {
      text += std::string("rule ") + head + " -> " +
              clauses[random() % clauses.size()] + " { ";
      if (*head == 'C') text += "C ";
      for (auto count = 1 + random() % 5; count > 0; --count)
        text += symbols[random() % symbols.size()] + " ";
      text += "}\n";
    }
    const Source source("a", text);
    const auto compiled = CompileWithMap(source);
    REQUIRE(compiled);
    const Genotype& genotype = compiled->program.genotype;
    std::set<std::pair<int, std::uint32_t>> read;
    std::set<std::pair<int, std::uint32_t>> alive;
    for (int i = 0; i < 4; ++i) {
      const auto history = DevelopWithHistory(
          genotype, {{static_cast<double>(i / 2), static_cast<double>(i % 2)}});
      REQUIRE(history);
      for (const Insertion& inserted : history->derivation.insertions)
        if (inserted.child_count > 0)
          alive.emplace(inserted.occurrence.rule, inserted.occurrence.position);
      const auto& string = history->derivation.string();
      for (std::size_t s = 0; s < string.size(); ++s) {
        const Occurrence& o = history->derivation[string[s]].occurrence;
        read.emplace(o.rule, o.position);
        if (InfoOf(history->trace->events[s].effect).is_expressed)
          alive.emplace(o.rule, o.position);
      }
    }
    std::set<std::uint32_t> expected;  // where dead symbols begin
    for (const auto& [rule, position] : read)
      if (rule != kNoRule && !alive.contains({rule, position}))
        expected.insert(compiled->map.rules[static_cast<std::size_t>(rule)]
                            .symbols[position]
                            .begin);
    std::set<std::uint32_t> found;
    for (const Diagnostic& warning : Linted(source))
      if (warning.message.starts_with("this '"))
        found.insert(warning.span.begin);
    INFO(text);
    REQUIRE(found == expected);
    dead_symbols += static_cast<int>(expected.size());
  }
  CHECK(dead_symbols > 300);
}

}  // namespace
}  // namespace plsc
