#include "runtime/evolve/crossover.h"

#include <catch2/catch.hpp>
#include <vector>

#include "runtime/evolve/initialise.h"
#include "tests/runtime/evolve/chi_square.h"

namespace plsc {

namespace {

using test::kSignificance;
using test::PValue;

Genotype Parent(std::uint64_t id, Encoding encoding) {
  GenotypeOptions options;
  options.encoding = encoding;
  Rng rng({9008, 0, id, Purpose::kInitialise});
  Genotype genotype = Initialise(options, rng);
  genotype.name = "robot_" + std::to_string(id);
  return genotype;
}

std::vector<Rule> RulesOf(const Genotype& genotype, SymbolId head) {
  std::vector<Rule> rules;
  for (const Rule& rule : genotype.rules)
    if (rule.head == head) rules.push_back(rule);
  return rules;
}

}  // namespace

TEST_CASE("A child has all rules of a symbol, clauses included, of one parent",
          "[crossover]") {
  for (const Encoding encoding :
       {Encoding::kPlasticoding, Encoding::kBaseline}) {
    const Genotype first = Parent(1, encoding);
    const Genotype second = Parent(2, encoding);
    for (unsigned mask = 0; mask < 32; ++mask) {
      CAPTURE(mask);
      std::vector<bool> from_second;
      for (unsigned bit = 0; bit < 5; ++bit)
        from_second.push_back((mask >> bit & 1) != 0);
      const Genotype child = Cross(first, second, from_second);
      CHECK(child.rules.size() == first.rules.size());
      for (std::uint16_t head = 0; head < 5; ++head) {
        const Genotype& parent = from_second[head] ? second : first;
        CHECK(RulesOf(child, SymbolId{head}) ==
              RulesOf(parent, SymbolId{head}));
      }
    }
  }
}

TEST_CASE("Settings and limits are the first parent's, the name nobody's",
          "[crossover]") {
  Genotype first = Parent(1, Encoding::kPlasticoding);
  const Genotype second = Parent(2, Encoding::kPlasticoding);
  first.development.iterations = 2;
  first.max_terms = 1;
  const Genotype child = Cross(first, second, {true, true, true, true, true});
  CHECK(child.development == first.development);
  CHECK(child.max_terms == first.max_terms);
  CHECK(child.states == first.states);
  CHECK(child.name.empty());
  CHECK(child.rules == second.rules);
}

TEST_CASE("A symbol without rules in the chosen parent has none in the child",
          "[crossover]") {
  Genotype first = Parent(1, Encoding::kBaseline);
  const Genotype second = Parent(2, Encoding::kBaseline);
  std::erase_if(first.rules,
                [](const Rule& rule) { return rule.head == plasticoding::kT; });
  const Genotype child =
      Cross(first, second, {false, true, false, true, false});
  CHECK(RulesOf(child, plasticoding::kT).empty());
  CHECK(child.rules.size() == 4);
}

TEST_CASE("Letters come from the second parent as in the authors' program",
          "[crossover]") {
  // Their 20,000 children at a crossover probability of 0.8, by the number of
  // letters (0 to 5) from the second parent.
  const std::vector<int> theirs = {4580, 2474, 5060, 4923, 2466, 497};
  std::vector<int> ours(6);
  std::vector<int> letters(5);
  for (std::uint64_t id = 0; id < 20000; ++id) {
    Rng rng({9008, 1, id, Purpose::kCrossover});
    std::size_t taken = 0;
    if (rng.Bernoulli(0.8)) {
      const auto choices = DrawCrossover(*PlasticodingAlphabet(), rng);
      REQUIRE(choices.size() == 5);
      for (std::size_t i = 0; i < 5; ++i) {
        letters[i] += choices[i] ? 1 : 0;
        taken += choices[i] ? 1 : 0;
      }
    }
    ++ours[taken];
  }
  CHECK(PValue(ours, theirs) > kSignificance);
  CHECK(PValue(letters, std::vector<double>(5, 1)) > kSignificance);
}

}  // namespace plsc
