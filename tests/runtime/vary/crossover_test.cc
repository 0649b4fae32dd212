#include "runtime/vary/crossover.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "runtime/evolve/breed.h"
#include "runtime/vary/initialise.h"
#include "tests/runtime/vary/reference_statistics.h"
#include "tests/sanitizer.h"

namespace plsc {

namespace {

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
  // Over children of two parents, with a crossover probability of 0.8.
  for (const Encoding encoding :
       {Encoding::kPlasticoding, Encoding::kBaseline}) {
    const bool is_plastic = encoding == Encoding::kPlasticoding;
    const nlohmann::json theirs =
        test::ReferenceStatistics(is_plastic ? "crossover_plastic_prob_0.8"
                                             : "crossover_baseline_prob_0.8");
    Experiment experiment;
    experiment.population = 2;
    experiment.mutation = 0;
    experiment.genotype.encoding = encoding;
    const std::vector<Individual> parents = {CreateFirst(experiment, 1),
                                             CreateFirst(experiment, 2)};
    test::Tally ours;
    for (int id = 3; id < 3 + test::Sampled(20000); ++id) {
      const Individual child = CreateChild(experiment, 1, id, parents, {0, 0});
      const Genotype& second =
          parents[static_cast<std::size_t>(child.heritage.parents[1] - 1)]
              .genotype;
      int taken = 0;
      for (std::uint16_t head = 0; head < 5; ++head) {
        const bool is_taken = RulesOf(child.genotype, SymbolId{head}) ==
                              RulesOf(second, SymbolId{head});
        taken += is_taken ? 1 : 0;
        ours.Count((*second.alphabet)[SymbolId{head}].name,
                   is_taken ? "second" : "first");
      }
      ours.Count("letters_from_second_parent_per_child", std::to_string(taken));
    }
    CHECK(ours.Disagreements(theirs, {"letters_from"}) ==
          std::vector<std::string>{});
    CHECK(ours.Disagreements(theirs.at("letters_from")) ==
          std::vector<std::string>{});
  }
}

TEST_CASE("A crossover of another probability is told from the authors'",
          "[crossover]") {
  const nlohmann::json theirs =
      test::ReferenceStatistics("crossover_plastic_prob_0.8");
  test::Tally ours;
  for (std::uint64_t id = 0; id < 20000; ++id) {
    Rng rng({9008, 1, id, Purpose::kCrossover});
    std::ptrdiff_t taken = 0;
    if (rng.Bernoulli(0.7)) {
      const auto choices = DrawCrossover(*PlasticodingAlphabet(), rng);
      REQUIRE(choices.size() == 5);
      taken = std::count(choices.begin(), choices.end(), true);
    }
    ours.Count("letters_from_second_parent_per_child", std::to_string(taken));
  }
  CHECK(ours.Disagreements(theirs, {"letters_from"}).size() == 1);
}

}  // namespace plsc
