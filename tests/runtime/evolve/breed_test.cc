#include "runtime/evolve/breed.h"

#include <catch2/catch.hpp>
#include <set>
#include <string>
#include <vector>

#include "compiler/compile.h"
#include "compiler/print.h"
#include "compiler/verify.h"
#include "tests/runtime/vary/chi_square.h"
#include "tests/sanitizer.h"

namespace plsc {

namespace {

using test::kSignificance;
using test::PValue;

std::vector<Individual> Population(const Experiment& experiment) {
  std::vector<Individual> population;
  for (int id = 1; id <= experiment.population; ++id)
    population.push_back(CreateFirst(experiment, id));
  return population;
}

/// With states of every type, so that every kind of term is varied.
Experiment Varied(Encoding encoding) {
  Experiment experiment;
  experiment.population = 20;
  experiment.genotype.encoding = encoding;
  experiment.genotype.max_terms = 3;
  experiment.genotype.states.push_back(
      {"temperature", StateType::kReal, -40, 60, {}});
  experiment.genotype.states.push_back(
      {"ground", StateType::kEnum, 0, 0, {"sand", "rock", "wet"}});
  return experiment;
}

}  // namespace

TEST_CASE("Ten thousand mutants pass Verify, and print as they are",
          "[breed]") {
  for (const Encoding encoding :
       {Encoding::kPlasticoding, Encoding::kBaseline}) {
    const Experiment experiment = Varied(encoding);
    std::vector<Individual> population = Population(experiment);
    const std::vector<int> counts(population.size(), 0);
    int id = experiment.population;
    const int generations = test::Sampled(250);
    for (int generation = 1; generation <= generations; ++generation) {
      std::vector<Individual> children;
      for (std::size_t i = 0; i < population.size(); ++i)
        children.push_back(
            CreateChild(experiment, generation, ++id, population, counts));
      for (const Individual& child : children) {
        const std::vector<std::string> broken = Verify(child.genotype);
        CAPTURE(child.id, broken);
        REQUIRE(broken.empty());
        if (child.id % 10 != 0) continue;  // compiling takes longer
        const auto program = Compile(Source("child", Print(child.genotype)));
        REQUIRE(program);
        REQUIRE(program->genotype == child.genotype);
      }
      population = std::move(children);
    }
    CHECK(id == 20 + generations * 20);
  }
}

TEST_CASE("A birth depends on who is born, not on who was before", "[breed]") {
  Experiment experiment;
  const Individual third = CreateFirst(experiment, 3);
  CHECK(CreateFirst(experiment, 3).genotype == third.genotype);
  CHECK(third.genotype.name == "robot_3");
  CHECK_FALSE(CreateFirst(experiment, 4).genotype.rules ==
              third.genotype.rules);
  experiment.seed = 2;
  CHECK_FALSE(CreateFirst(experiment, 3).genotype.rules ==
              third.genotype.rules);

  const std::vector<Individual> population = Population(experiment);
  const std::vector<int> counts(population.size(), 0);
  const Individual child = CreateChild(experiment, 1, 101, population, counts);
  CreateChild(experiment, 1, 102, population, counts);
  const Individual again = CreateChild(experiment, 1, 101, population, counts);
  CHECK(again.genotype == child.genotype);
  CHECK(again.heritage.parents == child.heritage.parents);
}

TEST_CASE("Heritage tells how a child came about", "[breed]") {
  Experiment experiment;
  experiment.population = 4;
  const std::vector<Individual> population = Population(experiment);
  const std::vector<int> counts = {0, 1, 2, 3};
  std::vector<int> crossed(2);
  std::vector<int> mutated(2);
  for (int id = 5; id < 4005; ++id) {
    const Individual child = CreateChild(experiment, 1, id, population, counts);
    const Heritage& heritage = child.heritage;
    REQUIRE(heritage.parents.size() == 2);
    REQUIRE(heritage.parents[0] != heritage.parents[1]);
    ++crossed[heritage.from_second.empty() ? 1 : 0];
    ++mutated[heritage.mutation ? 0 : 1];
    const auto parent = [&](std::size_t i) -> const Genotype& {
      return population[static_cast<std::size_t>(heritage.parents[i] - 1)]
          .genotype;
    };
    const std::set<SymbolId> second(heritage.from_second.begin(),
                                    heritage.from_second.end());
    for (std::size_t r = 0; r < child.genotype.rules.size(); ++r) {
      if (heritage.mutation && heritage.mutation->rule == r) continue;
      const SymbolId head = child.genotype.rules[r].head;
      REQUIRE(child.genotype.rules[r] ==
              parent(second.contains(head) ? 1 : 0).rules[r]);
    }
  }
  CHECK(PValue(mutated, std::vector<double>{0.8, 0.2}) > kSignificance);
  // Of crossovers, 1 of 32 takes nothing from the second parent.
  const double taken = 0.8 * 31 / 32;
  CHECK(PValue(crossed, std::vector<double>{taken, 1 - taken}) > kSignificance);
}

TEST_CASE("Without crossover and mutation a child is its first parent",
          "[breed]") {
  Experiment experiment;
  experiment.population = 4;
  experiment.crossover = 0;
  experiment.mutation = 0;
  const std::vector<Individual> population = Population(experiment);
  for (int id = 5; id < 50; ++id) {
    const Individual child =
        CreateChild(experiment, 1, id, population, {0, 1, 2, 3});
    const auto first = static_cast<std::size_t>(child.heritage.parents[0] - 1);
    CHECK(child.genotype.rules == population[first].genotype.rules);
    CHECK(child.genotype.name == "robot_" + std::to_string(id));
  }
}

}  // namespace plsc
