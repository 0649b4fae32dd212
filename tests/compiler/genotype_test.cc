#include "compiler/genotype.h"

#include <catch2/catch.hpp>
#include <functional>

namespace plsc {
namespace {

TEST_CASE("Genotypes are equal bit for bit", "[genotype]") {
  Genotype base;
  base.name = "g";
  base.states = {{"hot", StateType::kBool, 0, 0, {}}};
  Rule rule;
  rule.head = plasticoding::kT;
  rule.clause.terms = {Term{}};
  rule.production = {Symbol{plasticoding::kT, {0.0}}};
  base.rules = {rule};

  struct Row {
    const char* why;
    std::function<void(Genotype&)> change;
  };
  const std::vector<Row> rows = {
      {"name", [](Genotype& g) { g.name = "h"; }},
      {"state", [](Genotype& g) { g.states[0].name = "wet"; }},
      {"axiom", [](Genotype& g) { g.axiom = plasticoding::kB; }},
      {"iterations", [](Genotype& g) { g.development.iterations = 4; }},
      {"a limit", [](Genotype& g) { g.max_terms = 2; }},
      {"a comparison",
       [](Genotype& g) {
         g.rules[0].clause.terms[0].comparison = Comparison::kNotEqual;
       }},
      {"the sign of zero in a term",
       [](Genotype& g) { g.rules[0].clause.terms[0].value = -0.0; }},
      {"the sign of zero in an argument",
       [](Genotype& g) { g.rules[0].production[0].arguments[0] = -0.0; }},
      {"a rule more", [](Genotype& g) { g.rules.push_back(g.rules[0]); }},
  };
  CHECK(base == Genotype(base));
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      Genotype changed = base;
      row.change(changed);
      CHECK_FALSE(changed == base);
    }
  }
}

}  // namespace
}  // namespace plsc
