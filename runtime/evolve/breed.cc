// A birth as a function of (seed, generation, id) and the parents: each purpose
// has a stream of its own (vary/rng), so whether a child is crossed does not
// shift what its mutation draws, and children may be made in any order. What
// parents hand down is inherit's to say. The order within a stream is part of
// every result.

#include "runtime/evolve/breed.h"

#include <fmt/format.h>

#include <utility>

#include "runtime/evolve/inherit.h"
#include "runtime/evolve/select.h"
#include "runtime/vary/crossover.h"

namespace plsc {

namespace {

Rng StreamFor(const Experiment& experiment, int generation, int id,
              Purpose purpose) {
  return Rng({experiment.seed, static_cast<std::uint64_t>(generation),
              static_cast<std::uint64_t>(id), purpose});
}

std::vector<SymbolId> HeadsFromSecond(const Alphabet& alphabet,
                                      const std::vector<bool>& from_second) {
  std::vector<SymbolId> heads;
  std::size_t choice = 0;
  for (std::size_t i = 0; i < alphabet.symbols().size(); ++i)
    if (alphabet.symbols()[i].is_replaceable && from_second[choice++])
      heads.push_back(static_cast<SymbolId>(i));
  return heads;
}

std::string NameOf(const Experiment& experiment, int id) {
  return fmt::format("{}_{}", experiment.robots, id);
}

}  // namespace

Individual CreateFirst(const Experiment& experiment, int id) {
  Rng rng = StreamFor(experiment, 0, id, Purpose::kInitialise);
  Individual individual;
  individual.id = id;
  individual.genotype = Initialise(experiment.genotype, rng);
  individual.genotype.name = NameOf(experiment, id);
  return individual;
}

Individual CreateChild(const Experiment& experiment, int generation, int id,
                       const std::vector<Individual>& population,
                       const std::vector<int>& scores) {
  const auto stream = [&](Purpose purpose) {
    return StreamFor(experiment, generation, id, purpose);
  };
  Rng rng = stream(Purpose::kSelectParents);
  const std::vector<std::size_t> pair =
      SelectDistinct(scores, 2, experiment.tournament, rng);
  const Individual& first = population[pair[0]];
  const Individual& second = population[pair[1]];

  Individual child;
  child.id = id;
  child.generation = generation;
  child.heritage.parents = {first.id, second.id};
  if (experiment.inheritance == Inheritance::kSenses)
    child.heritage.senses = LastSenses(first);
  child.genotype = HandedDown(first, experiment);
  rng = stream(Purpose::kCrossover);
  if (rng.Bernoulli(experiment.crossover)) {
    const Alphabet& alphabet = *child.genotype.alphabet;
    const std::vector<bool> choices = DrawCrossover(alphabet, rng);
    child.heritage.from_second = HeadsFromSecond(alphabet, choices);
    child.genotype =
        Cross(child.genotype, HandedDown(second, experiment), choices);
  }
  rng = stream(Purpose::kMutate);
  if (rng.Bernoulli(experiment.mutation)) {
    const Mutation mutation =
        DrawMutation(child.genotype, experiment.genotype.encoding, rng,
                     experiment.variation);
    child.heritage.mutation = mutation;
    child.genotype =
        Mutate(std::move(child.genotype), mutation, rng, experiment.variation);
  }
  child.genotype.name = NameOf(experiment, id);
  return child;
}

}  // namespace plsc
