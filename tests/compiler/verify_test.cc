#include "compiler/verify.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "compiler/compiled.h"

namespace plsc {
namespace {

using testing::Compiled;

Program Base() {
  return Compiled(
      "plsc 1 genotype g alphabet plasticoding 1 max_terms 2 max_rules 2 "
      "sense a: bool sense r: real in 0..9 sense e: { x, y }\n"
      "rule C -> { C T(0.5) }\n"
      "rule B -> if a = True and r > 2 then { move_ref_I(1, 2) }\n"
      "rule B -> { B }\n"
      "environment one { a = True, r = 0, e = y }");
}

struct VerifyRow {
  const char* why;
  std::function<void(Program&)> change;
};

void CheckAllBroken(const std::vector<VerifyRow>& rows) {
  for (const VerifyRow& row : rows) {
    DYNAMIC_SECTION(row.why) {
      Program program = Base();
      REQUIRE(Verify(program).empty());
      row.change(program);
      CHECK_FALSE(Verify(program).empty());
    }
  }
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST_CASE("A header that breaks an invariant is found", "[verify]") {
  CheckAllBroken({
      {"no alphabet", [](Program& p) { p.genotype.alphabet = nullptr; }},
      {"a name that is a keyword",
       [](Program& p) { p.genotype.name = "rule"; }},
      {"a name with a blank", [](Program& p) { p.genotype.name = "a b"; }},
      {"an axiom that is not C",
       [](Program& p) { p.genotype.axiom = plasticoding::kB; }},
      {"an axiom beyond the alphabet",
       [](Program& p) { p.genotype.axiom = SymbolId{99}; }},
      {"iterations below 0",
       [](Program& p) { p.genotype.development.iterations = -1; }},
      {"iterations above 100",
       [](Program& p) { p.genotype.development.iterations = 101; }},
      {"no modules",
       [](Program& p) { p.genotype.development.max_modules = 0; }},
      {"a limit of nothing", [](Program& p) { p.genotype.max_terms = 0; }},
      {"two states of a name",
       [](Program& p) { p.genotype.states[1].name = "a"; }},
      {"an empty range", [](Program& p) { p.genotype.states[1].high = 0; }},
      {"an infinite range",
       [](Program& p) { p.genotype.states[1].high = INFINITY; }},
      {"one value", [](Program& p) { p.genotype.states[2].values = {"x"}; }},
      {"equal values",
       [](Program& p) {
         p.genotype.states[2].values = {"x", "x"};
       }},
  });
}

TEST_CASE("A rule that breaks an invariant is found", "[verify]") {
  CheckAllBroken({
      {"an empty production",
       [](Program& p) { p.genotype.rules[2].production.clear(); }},
      {"a head that is not replaceable",
       [](Program& p) { p.genotype.rules[2].head = plasticoding::kLoop; }},
      {"a head beyond the alphabet",
       [](Program& p) { p.genotype.rules[2].head = SymbolId{77}; }},
      {"a symbol beyond the alphabet",
       [](Program& p) { p.genotype.rules[2].production[0].id = SymbolId{77}; }},
      {"rules out of order",
       [](Program& p) { std::swap(p.genotype.rules[0], p.genotype.rules[1]); }},
      {"more rules than max_rules",
       [](Program& p) { p.genotype.rules.push_back(p.genotype.rules.back()); }},
      {"C inside a rule for C",
       [](Program& p) { p.genotype.rules[0].production.push_back(Symbol{}); }},
      {"C missing in a rule for C",
       [](Program& p) {
         auto& production = p.genotype.rules[0].production;
         production.erase(production.begin());
       }},
      {"C in another rule",
       [](Program& p) { p.genotype.rules[2].production[0] = Symbol{}; }},
  });
}

TEST_CASE("An argument that breaks an invariant is found", "[verify]") {
  const auto argument = [](double value) {
    return [value](Program& p) {
      p.genotype.rules[0].production[1].arguments[0] = value;
    };
  };
  const auto edge = [](double value) {
    return [value](Program& p) {
      p.genotype.rules[1].production[0].arguments[0] = value;
    };
  };
  CheckAllBroken({
      {"not a number", argument(kNan)},
      {"infinite", argument(INFINITY)},
      {"out of range", argument(1.5)},
      {"not whole", edge(1.5)},
      {"too large to be whole for sure", edge(1e17)},
      {"an unused place in use",
       [](Program& p) { p.genotype.rules[0].production[1].arguments[1] = 1; }},
      {"an unused place of minus zero",
       [](Program& p) {
         p.genotype.rules[0].production[1].arguments[1] = -0.0;
       }},
  });
}

TEST_CASE("A clause or environment that breaks an invariant is found",
          "[verify]") {
  const auto clause = [](auto change) {
    return [change](Program& p) { change(p.genotype.rules[1].clause); };
  };
  CheckAllBroken({
      {"a connective too few",
       clause([](Clause& c) { c.connectives.clear(); })},
      {"a connective too many",
       clause([](Clause& c) { c.connectives.push_back(Connective::kOr); })},
      {"an unknown state",
       clause([](Clause& c) { c.terms[0].state = StateId{9}; })},
      {"a bool that is 2", clause([](Clause& c) { c.terms[0].value = 2; })},
      {"a bool that is minus zero",
       clause([](Clause& c) { c.terms[0].value = -0.0; })},
      {"an ordered bool",
       clause([](Clause& c) { c.terms[0].comparison = Comparison::kLess; })},
      {"a threshold that is no number",
       clause([](Clause& c) { c.terms[1].value = kNan; })},
      {"more terms than max_terms", clause([](Clause& c) {
         c.terms.push_back(c.terms[0]);
         c.connectives.push_back(Connective::kOr);
       })},
      {"an enum's value that there is not", clause([](Clause& c) {
         c.terms[0] = {StateId{2}, {}, 2};
       })},
      {"an environment without values",
       [](Program& p) { p.environments[0].environment.values.clear(); }},
      {"an environment out of range",
       [](Program& p) { p.environments[0].environment.values[1] = 10; }},
      {"two environments of a name",
       [](Program& p) { p.environments.push_back(p.environments[0]); }},
  });
}

TEST_CASE("An own alphabet that breaks an invariant is found", "[verify]") {
  const auto with = [](const std::string& name, std::vector<SymbolInfo> symbols,
                       int version = 0) {
    Genotype genotype;
    genotype.name = "g";
    genotype.alphabet =
        std::make_shared<const Alphabet>(name, version, std::move(symbols));
    return genotype;
  };
  const SymbolInfo x{"X", Category::kModule, true, {}, ""};
  Parameter half;
  half.name = "p";
  half.low = 1;
  CHECK(Verify(with("m", {x})).empty());
  CHECK_FALSE(Verify(with("m", {})).empty());
  CHECK_FALSE(Verify(with("m", {x, x})).empty());
  CHECK_FALSE(Verify(with("plasticoding", {x})).empty());
  CHECK_FALSE(Verify(with("plasticoding", {x}, 1)).empty());
  CHECK_FALSE(
      Verify(with("m", {{"if", Category::kModule, true, {}, ""}})).empty());
  CHECK_FALSE(Verify(with("m", {x, {"Y", Category::kModule, true, {half}, ""}}))
                  .empty());
}

}  // namespace
}  // namespace plsc
