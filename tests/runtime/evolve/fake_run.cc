#include "tests/runtime/evolve/fake_run.h"

namespace plsc::test {

namespace {

double Share(const Genotype& genotype, SymbolId id) {
  int count = 0;
  int all = 0;
  for (const Rule& rule : genotype.rules)
    for (const Symbol& symbol : rule.production) {
      count += symbol.id == id ? 1 : 0;
      ++all;
    }
  return static_cast<double>(count) / all;
}

}  // namespace

Experiment SmallExperiment() {
  Experiment experiment;
  experiment.population = 8;
  experiment.offspring = 6;
  experiment.generations = 5;
  return experiment;
}

Evaluation Look(const Genotype& genotype) {
  Evaluation evaluation;
  SeasonResult flat;
  flat.season = "flat";
  flat.fitness = Share(genotype, plasticoding::kA1);
  SeasonResult tilted;
  tilted.season = "tilted";
  tilted.fitness = Share(genotype, plasticoding::kT);
  if (IdOf(genotype) % 11 == 0) {
    tilted.outcome = Outcome::kOverlapping;
    tilted.fitness.reset();
  }
  evaluation.seasons = {flat, tilted};
  return evaluation;
}

int IdOf(const Genotype& genotype) {
  return std::stoi(genotype.name.substr(genotype.name.find('_') + 1));
}

std::optional<std::string> Recorder::OnBirths(const std::vector<Individual>&) {
  return std::nullopt;
}

std::optional<std::string> Recorder::OnEvaluated(
    const Individual& one, const std::vector<SeasonEvidence>&) {
  if (one.id == failing_id) return "the disk is full";
  individuals.push_back(one);
  return std::nullopt;
}

std::optional<std::string> Recorder::OnGeneration(
    const GenerationRecord& record) {
  generations.push_back(record);
  return std::nullopt;
}

}  // namespace plsc::test
