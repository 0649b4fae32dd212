#include "runtime/develop/derive.h"

#include <catch2/catch.hpp>

#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

std::string Text(const Genotype& genotype, const SymbolString& string) {
  std::string text;
  for (const Occurrence& o : string) {
    if (!text.empty()) text += ' ';
    text += (*genotype.alphabet)[o.symbol].name;
  }
  return text;
}

std::string DerivedText(const Genotype& genotype) {
  return Text(genotype, *Derive(genotype, Regulate(genotype, {})));
}

TEST_CASE("the paper's didactic grammar derives as printed there", "[derive]") {
  const Genotype genotype = test::Didactic(
      "iterations 3\nrule X -> { X Y }\nrule Y -> { Z a }\n"
      "rule Z -> { X Z }\n");
  const auto steps = DeriveSteps(genotype, Regulate(genotype, {}));
  REQUIRE(steps);
  std::vector<std::string> texts;
  for (const SymbolString& step : *steps) texts.push_back(Text(genotype, step));
  CHECK(texts ==
        std::vector<std::string>{"X", "X Y", "X Y Z a", "X Y Z a X Z a"});
}

TEST_CASE("a symbol without an active rule stays", "[derive]") {
  CHECK(DerivedText(test::Didactic("iterations 2\nrule X -> { Y a }\n")) ==
        "Y a");
  CHECK(DerivedText(test::Didactic("iterations 0\nrule X -> { Y a }\n")) ==
        "X");
  CHECK(DerivedText(test::Didactic("iterations 5\nrule Y -> { a }\n")) == "X");
}

TEST_CASE("every symbol knows the rule and the place that wrote it",
          "[derive]") {
  const Genotype genotype =
      test::Didactic("iterations 2\nrule X -> { Y a }\nrule Y -> { a Z }\n");
  const auto string = Derive(genotype, Regulate(genotype, {}));
  REQUIRE(string);
  CHECK(*string == SymbolString{{SymbolId{3}, 1, 0},
                                {SymbolId{2}, 1, 1},
                                {SymbolId{3}, 0, 1}});
}

TEST_CASE("a string that would outgrow the limit is not made", "[derive]") {
  // 2^20 is the limit, exactly reached by twenty doublings.
  const auto derive = [](int iterations) {
    const Genotype genotype = test::Didactic(
        "iterations " + std::to_string(iterations) + "\nrule X -> { X X }\n");
    return Derive(genotype, Regulate(genotype, {}));
  };
  REQUIRE(derive(20));
  CHECK(derive(20)->size() == kMaxStringLength);
  CHECK_FALSE(derive(21));
  CHECK_FALSE(derive(100));
}

// The oracle: one symbol, `depth` rewritings, by recursion.
void NaiveDerive(const Genotype& genotype, SymbolId symbol, int depth,
                 std::vector<SymbolId>& out) {
  bool is_replaced = false;
  if (depth > 0)
    for (const Rule& rule : genotype.rules) {
      if (rule.head != symbol || !rule.clause.is_always()) continue;
      is_replaced = true;
      for (const Symbol& next : rule.production)
        NaiveDerive(genotype, next.id, depth - 1, out);
    }
  if (!is_replaced) out.push_back(symbol);
}

TEST_CASE("all tiny grammars derive as by recursion", "[derive]") {
  // Every pair of productions for X and Y out of these, 0 to 4 rewritings.
  const std::vector<std::string> productions = {
      "",        "{ X }",   "{ Y }",   "{ a }",     "{ X Y }",
      "{ Y X }", "{ X X }", "{ a X }", "{ Y a Y }", "{ Z X a }"};
  int compared = 0;
  for (const std::string& x : productions)
    for (const std::string& y : productions)
      for (int iterations = 0; iterations <= 4; ++iterations) {
        std::string rules = "iterations " + std::to_string(iterations) + "\n";
        if (!x.empty()) rules += "rule X -> " + x + "\n";
        if (!y.empty()) rules += "rule Y -> " + y + "\n";
        const Genotype genotype = test::Didactic(rules);
        std::vector<SymbolId> expected;
        NaiveDerive(genotype, genotype.axiom, iterations, expected);
        const auto string = Derive(genotype, Regulate(genotype, {}));
        REQUIRE(string);
        std::vector<SymbolId> actual;
        for (const Occurrence& o : *string) actual.push_back(o.symbol);
        INFO(rules);
        REQUIRE(actual == expected);
        ++compared;
      }
  CHECK(compared == 500);
}

}  // namespace
}  // namespace plsc
