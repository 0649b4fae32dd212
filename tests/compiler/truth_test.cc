#include "compiler/truth.h"

#include <catch2/catch.hpp>

#include "compiler/compiled.h"
#include "compiler/random_genotype.h"

namespace plsc {
namespace {

using testing::Compiled;

// The meaning of a clause, spelled out: split at `or`, all of each part.
bool NaiveHolds(const Clause& clause, const std::vector<double>& values) {
  if (clause.terms.empty()) return true;
  std::vector<std::vector<Term>> parts(1);
  for (std::size_t i = 0; i < clause.terms.size(); ++i) {
    if (i > 0 && clause.connectives[i - 1] == Connective::kOr)
      parts.emplace_back();
    parts.back().push_back(clause.terms[i]);
  }
  bool any = false;
  for (const auto& part : parts) {
    bool all = true;
    for (const Term& term : part) {
      const double value = values[static_cast<std::size_t>(term.state)];
      const bool holds[] = {
          value == term.value, value != term.value,
          value<term.value, value <= term.value, value> term.value,
          value >= term.value};
      all = all && holds[static_cast<int>(term.comparison)];
    }
    any = any || all;
  }
  return any;
}

TEST_CASE("Clauses hold as spelled out, in every environment", "[truth]") {
  int checked = 0;
  for (std::uint32_t seed = 1; seed <= 300; ++seed) {
    const Genotype genotype = testing::RandomProgram(seed).genotype;
    for (const Rule& rule : genotype.rules) {
      const Clause* const one = &rule.clause;
      const StateSpace space({&one, 1}, genotype.states);
      if (!space.size()) continue;
      for (int i = 0; i < *space.size(); ++i) {
        const std::vector<double> values = space.At(i);
        REQUIRE(ClauseHolds(rule.clause, values) ==
                NaiveHolds(rule.clause, values));
        ++checked;
      }
    }
  }
  CHECK(checked > 1000);
}

TEST_CASE("and binds tighter than or", "[truth]") {
  const Genotype genotype =
      Compiled(
          "plsc 1 alphabet plasticoding 1 sense a: bool sense b: bool "
          "sense c: bool rule B -> if a = True or b = True and c = True "
          "then { B }")
          .genotype;
  const Clause& clause = genotype.rules[0].clause;
  CHECK(ClauseHolds(clause, std::vector<double>{1, 0, 0}));
  CHECK(ClauseHolds(clause, std::vector<double>{0, 1, 1}));
  CHECK_FALSE(ClauseHolds(clause, std::vector<double>{0, 1, 0}));
  const auto count = CountTruth(clause, genotype.states);
  REQUIRE(count);
  CHECK(count->holds == 5);
  CHECK(count->total == 8);
}

TEST_CASE("Real states are told apart at and between thresholds", "[truth]") {
  const Genotype genotype =
      Compiled(
          "plsc 1 alphabet plasticoding 1 sense r: real in 0..10 "
          "rule B -> if r < 4 or r > 6 then { B }")
          .genotype;
  const Clause* const one = &genotype.rules[0].clause;
  const StateSpace space({&one, 1}, genotype.states);
  REQUIRE(space.size() == 7);  // 0, 2, 4, 5, 6, 8, 10
  std::vector<double> samples;
  for (int i = 0; i < 7; ++i) samples.push_back(space.At(i)[0]);
  CHECK(samples == std::vector<double>{0, 2, 4, 5, 6, 8, 10});
}

TEST_CASE("The last state varies fastest", "[truth]") {
  const Genotype genotype =
      Compiled(
          "plsc 1 alphabet plasticoding 1 sense a: bool sense unused: bool "
          "sense e: { x, y, z } rule B -> if e = x and a = True then { B }")
          .genotype;
  const Clause* const one = &genotype.rules[0].clause;
  const StateSpace space({&one, 1}, genotype.states);
  REQUIRE(space.size() == 6);
  CHECK(space.states() == std::vector<StateId>{StateId{0}, StateId{2}});
  CHECK(space.At(1) == std::vector<double>{0, 0, 1});
  CHECK(space.At(3) == std::vector<double>{1, 0, 0});
}

}  // namespace
}  // namespace plsc
