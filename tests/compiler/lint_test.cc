#include "compiler/lint.h"

#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "compiler/compile.h"
#include "compiler/print.h"
#include "compiler/random_genotype.h"
#include "compiler/truth.h"

namespace plsc {
namespace {

std::vector<Diagnostic> Linted(const Source& source) {
  const Result<MappedProgram> compiled = CompileWithMap(source);
  INFO(Render(compiled.diagnostics(), source));
  REQUIRE(compiled);
  return LintClauses(compiled->program, compiled->map);
}

TEST_CASE("Environments in which no rule is active are found", "[lint]") {
  const std::string head =
      "plsc 1\nalphabet plasticoding 1\nsense a: bool\nsense b: bool\n";
  struct Row {
    const char* why;
    const char* rules;
    const char* message;  // "" for none
  };
  const std::vector<Row> rows = {
      {"no rules, no gap", "", ""},
      {"always active", "rule B -> { B }", ""},
      {"two halves",
       "rule B -> if a = True then { B } rule B -> if a = False then { T(1) }",
       ""},
      {"one half", "rule B -> if a = True then { B }",
       "no rule for 'B' is active when a = False"},
      {"one of four",
       "rule B -> if a = True then { B } rule B -> if b = False then { T(1) }",
       "no rule for 'B' is active when a = False and b = True"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const Source source("a", head + row.rules);
      std::vector<Diagnostic> found = Linted(source);
      std::erase_if(found, [](const Diagnostic& d) {
        return d.code != Code::kNoActiveRule;
      });
      REQUIRE(found.size() == (*row.message == '\0' ? 0 : 1));
      if (found.empty()) continue;
      CHECK(found[0].code == Code::kNoActiveRule);
      CHECK(found[0].severity == Severity::kWarning);
      CHECK(found[0].message == row.message);
      CHECK(source.text().substr(found[0].span.begin, 1) == "B");
    }
  }
}

TEST_CASE("A gap tells how large it is", "[lint]") {
  const Source source("a",
                      "plsc 1 alphabet plasticoding 1 sense a: bool "
                      "sense b: bool rule T -> if a = True and b = True then "
                      "{ T(1) }");
  const std::vector<Diagnostic> found = Linted(source);
  REQUIRE(found.size() == 1);
  CHECK(found[0].label == "T stays as it is in 3 of 4 environments");
}

TEST_CASE("Rules that are joined by accident are found", "[lint]") {
  const std::string head =
      "plsc 1\nalphabet plasticoding 1\nsense a: bool\n"
      "sense b: bool\nsense t: real in 0..10\n";
  struct Row {
    const char* why;
    const char* rules;
    const char* message;  // "" for none
    const char* label;
  };
  const std::vector<Row> rows = {
      {"one always active: the others are meant to be joined",
       "rule B -> { B } rule B -> if a = True then { B } "
       "rule B -> if b = True then { B }",
       "", ""},
      {"active everywhere by its clause",
       "rule B -> if a = True or a = False then { B } "
       "rule B -> if b = True then { B }",
       "", ""},
      {"each excludes the other",
       "rule B -> if a = True then { B } rule B -> if a = False then { B }", "",
       ""},
      {"symbols have nothing to do with each other",
       "rule B -> if a = True then { B } rule B -> if a = False then { B } "
       "rule T -> if b = True then { B } rule T -> if b = False then { B }",
       "", ""},
      {"both ends of a threshold",
       "rule B -> if t <= 5 then { B } rule B -> if t >= 5 then { B }",
       "2 rules for 'B' are active when t = 5",
       "joined in 1 of 3 environments"},
      {"a threshold told apart",
       "rule B -> if t < 5 then { B } "
       "rule B -> if t >= 5 then { B }",
       "", ""},
      {"three at once",
       "rule B -> if a = True then { B } rule B -> if a != False then { B } "
       "rule B -> if b = True or a = False or a = True and b != True then { B "
       "}",
       "", ""},
      {"two of three",
       "rule B -> if a = True then { B } rule B -> if a = False then { B } "
       "rule B -> if a = True and b = True then { B }",
       "2 rules for 'B' are active when a = True and b = True",
       "joined in 1 of 4 environments"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const Source source("a", head + row.rules);
      const std::vector<Diagnostic> found = Linted(source);
      REQUIRE(found.size() == (*row.message == '\0' ? 0 : 1));
      if (found.empty()) continue;
      CHECK(found[0].code == Code::kSeveralActiveRules);
      CHECK(found[0].message == row.message);
      CHECK(found[0].label == row.label);
      REQUIRE(found[0].others.size() == 1);
      CHECK(found[0].others[0].span.begin < found[0].span.begin);
    }
  }
}

TEST_CASE("Clauses that nobody could tabulate are named", "[lint]") {
  std::string text = "plsc 1 alphabet plasticoding 1\n";
  std::string clause;
  for (int i = 0; i < 17; ++i) {
    text += "sense s" + std::to_string(i) + ": bool\n";
    clause += (i == 0 ? "s" : " and s") + std::to_string(i) + " = True";
  }
  const Source source("a", text + "rule B -> if " + clause + " then { B }");
  const std::vector<Diagnostic> found = Linted(source);
  REQUIRE(found.size() == 1);
  CHECK(found[0].code == Code::kUnchecked);
}

// The oracle: verdicts on random clauses, by asking every clause in every
// environment.
TEST_CASE("Gaps and joins are those that brute force finds", "[lint]") {
  int gaps = 0;
  int joins = 0;
  for (std::uint32_t seed = 1; seed <= 600; ++seed) {
    const Source source("a", Print(testing::RandomProgram(seed)));
    const Result<MappedProgram> compiled = CompileWithMap(source);
    REQUIRE(compiled);
    const Genotype& genotype = compiled->program.genotype;
    const StateSpace space(genotype);
    if (!space.size()) continue;
    std::multiset<std::string> expected;
    for (std::size_t head = 0; head < genotype.alphabet->symbols().size();
         ++head) {
      bool has_rules = false;
      bool has_gap = false;
      bool has_join = false;
      std::vector<bool> is_constant(genotype.rules.size(), true);
      for (int i = 0; i < *space.size(); ++i) {
        int active = 0;
        for (std::size_t r = 0; r < genotype.rules.size(); ++r) {
          if (static_cast<std::size_t>(genotype.rules[r].head) != head)
            continue;
          has_rules = true;
          const bool holds = ClauseHolds(genotype.rules[r].clause, space.At(i));
          active += holds ? 1 : 0;
          if (!holds) is_constant[r] = false;
        }
        has_gap = has_gap || active == 0;
        has_join = has_join || active > 1;
      }
      bool has_constant = false;
      for (std::size_t r = 0; r < genotype.rules.size(); ++r)
        has_constant =
            has_constant ||
            (static_cast<std::size_t>(genotype.rules[r].head) == head &&
             is_constant[r]);
      if (!has_rules) continue;
      if (has_gap) expected.insert("W3003");
      if (has_join && !has_constant) expected.insert("W3004");
    }
    std::multiset<std::string> found;
    for (const Diagnostic& warning :
         LintClauses(compiled->program, compiled->map))
      found.emplace(NumberOf(warning.code));
    INFO(source.text());
    REQUIRE(found == expected);
    gaps += static_cast<int>(expected.count("W3003"));
    joins += static_cast<int>(expected.count("W3004"));
  }
  CHECK(gaps > 100);
  CHECK(joins > 100);
}

}  // namespace
}  // namespace plsc
