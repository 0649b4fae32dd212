#include "compiler/truth.h"

#include <catch2/catch.hpp>
#include <random>

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

TEST_CASE("A table holds what each clause says, environment by environment",
          "[truth]") {
  int checked = 0;
  for (std::uint32_t seed = 1; seed <= 1000; ++seed) {
    const Genotype genotype = testing::RandomProgram(seed).genotype;
    const StateSpace space(genotype);
    if (!space.size()) continue;
    for (const Rule& rule : genotype.rules) {
      const TruthTable table = Tabulate(rule.clause, space);
      REQUIRE(table.size() == *space.size());
      int count = 0;
      std::optional<int> first;
      for (int i = 0; i < *space.size(); ++i) {
        const bool holds = NaiveHolds(rule.clause, space.At(i));
        CAPTURE(seed, i);
        REQUIRE(table[i] == holds);
        if (holds && count++ == 0) first = i;
        ++checked;
      }
      CHECK(table.Count() == count);
      CHECK(table.First() == first);
    }
  }
  CHECK(checked > 10000);
}

TEST_CASE("Tables of every shape agree with the clause", "[truth]") {
  // Numbers of values whose runs are shorter than a machine word, longer, and
  // no divisor of it; up to the 65,536 environments of sixteen bool states.
  const std::vector<std::vector<int>> shapes = {
      {2},       {3},          {2, 3},    {3, 2},    {64, 2},
      {2, 64},   {65, 3},      {3, 65},   {7, 9, 5}, {5, 1, 2},
      {100, 64}, {2, 2, 2, 2}, {128, 512}};
  for (std::vector<int> shape : shapes) {
    if (shape == std::vector<int>{128, 512}) shape.assign(16, 2);
    std::vector<State> states;
    Clause all;  // names every value, so that every value is a class
    for (const int values : shape) {
      State state;
      state.type = StateType::kEnum;
      state.values.assign(static_cast<std::size_t>(values), "v");
      states.push_back(state);
    }
    for (std::size_t s = 0; s < states.size(); ++s)
      for (int value = 0; value < shape[s]; ++value) {
        if (!all.terms.empty())
          all.connectives.push_back(
              (static_cast<std::size_t>(value) + s) % 3 == 0 ? Connective::kAnd
                                                             : Connective::kOr);
        all.terms.push_back(
            {static_cast<StateId>(s),
             value % 2 == 0 ? Comparison::kEqual : Comparison::kNotEqual,
             static_cast<double>(value)});
      }
    const Clause* const one = &all;
    const StateSpace space({&one, 1}, states);
    int product = 1;
    for (const int values : shape) product *= values;
    REQUIRE(space.size() == product);
    const TruthTable table = Tabulate(all, space);
    TruthTable inverse = table;
    inverse.Invert();
    for (int i = 0; i < product; ++i) {
      REQUIRE(table[i] == NaiveHolds(all, space.At(i)));
      REQUIRE(inverse[i] != table[i]);
    }
    CHECK(table.Count() + inverse.Count() == product);
    inverse |= table;
    CHECK(inverse.Count() == product);
    CHECK_FALSE(TruthTable(product, false).First());
  }
}

TEST_CASE("Clauses are counted as their table has it", "[truth]") {
  // Up to eight bool states: six fit a word, more do not. The last is an enum.
  std::vector<State> states(9);
  states[8].type = StateType::kEnum;
  states[8].values = {"a", "b", "c"};
  std::mt19937 random(7);
  const auto draw = [&](std::size_t count) { return random() % count; };
  for (int i = 0; i < 3000; ++i) {
    const std::size_t used = 1 + draw(states.size());
    Clause clause;
    for (std::size_t k = draw(13); k > 0; --k) {
      if (!clause.terms.empty())
        clause.connectives.push_back(draw(2) == 0 ? Connective::kAnd
                                                  : Connective::kOr);
      clause.terms.push_back(
          {static_cast<StateId>(draw(used)),
           draw(2) == 0 ? Comparison::kEqual : Comparison::kNotEqual,
           static_cast<double>(draw(2))});
    }
    const Clause* const one = &clause;
    const StateSpace space({&one, 1}, states);
    int holds = 0;
    for (int row = 0; row < *space.size(); ++row)
      holds += NaiveHolds(clause, space.At(row)) ? 1 : 0;
    const auto count = CountTruth(clause, states);
    CAPTURE(i);
    REQUIRE(count);
    REQUIRE(count->holds == holds);
    REQUIRE(count->total == *space.size());
  }
}

TEST_CASE("Sixteen bool states are counted, seventeen are too many",
          "[truth]") {
  for (const int count : {16, 17}) {
    std::vector<State> states(static_cast<std::size_t>(count));
    Clause clause;
    for (int i = 0; i < count; ++i) {
      if (i > 0) clause.connectives.push_back(Connective::kAnd);
      clause.terms.push_back({static_cast<StateId>(i), Comparison::kEqual, 1});
    }
    const auto truth = CountTruth(clause, states);
    REQUIRE(truth.has_value() == (count == 16));
    if (!truth) continue;
    CHECK(truth->total == 65536);
    CHECK(truth->holds == 1);
  }
}

}  // namespace
}  // namespace plsc
