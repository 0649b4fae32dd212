#include "runtime/develop/regimes.h"

#include <catch2/catch.hpp>
#include <map>

#include "runtime/develop/regulate.h"
#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

TEST_CASE("Environments with the same active rules are one regime",
          "[regimes]") {
  const std::vector<std::string> genotypes = {
      "",
      "rule X -> { a }",
      "sense p: bool rule X -> if p = True then { a }",
      "sense p: bool sense q: bool rule X -> if p = True then { a } "
      "rule Y -> if p = True or q = True then { a }",
      "sense e: { u, v, w } sense t: real in 0..9 "
      "rule X -> if e = v and t > 3 then { a } "
      "rule Y -> if e != w or t <= 5 then { X } rule Y -> { a }",
  };
  for (const std::string& text : genotypes) {
    const Genotype genotype = test::Didactic(text);
    const StateSpace space(genotype);
    std::map<std::vector<RuleIndex>, std::pair<int, int>> expected;
    for (int i = 0; i < *space.size(); ++i) {
      const auto rules = Regulate(genotype, {space.At(i)}).rules;
      ++expected.emplace(rules, std::pair{i, 0}).first->second.second;
    }
    const auto regimes = FindRegimes(ClausesOf(genotype), space);
    INFO(text);
    REQUIRE(regimes);
    std::map<std::vector<RuleIndex>, std::pair<int, int>> found;
    int last = -1;
    for (const Regime& regime : *regimes) {
      const auto rules =
          Regulate(genotype, {space.At(regime.environment)}).rules;
      CHECK(found.emplace(rules, std::pair{regime.environment, regime.count})
                .second);
      CHECK(regime.environment > last);
      last = regime.environment;
    }
    CHECK(found == expected);
  }
}

}  // namespace
}  // namespace plsc
