#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <vector>

#include "compiler/compile.h"
#include "compiler/print.h"
#include "grammar/expected.h"
#include "runtime/cli/arguments/robots.h"
#include "runtime/cli/commands/offspring.h"
#include "runtime/cli/files/load_yaml.h"
#include "runtime/cli/files/output_path.h"
#include "runtime/evolve/breed.h"
#include "runtime/vary/initialise.h"
#include "runtime/vary/rng.h"

namespace plsc::cli {

namespace {

GenotypeOptions OptionsOf(const RandomCommand& command) {
  GenotypeOptions options;
  options.encoding = command.encoding == "baseline" ? Encoding::kBaseline
                                                    : Encoding::kPlasticoding;
  options.states.clear();
  if (options.encoding == Encoding::kPlasticoding)
    for (const std::string& name : command.states)
      options.states.push_back({name, StateType::kBool, 0, 0, {}});
  options.max_groups = command.max_groups;
  options.max_rules = command.max_rules;
  options.max_terms = command.max_terms;
  return options;
}

std::vector<Genotype> DrawSome(const RandomCommand& command) {
  const GenotypeOptions options = OptionsOf(command);
  const int count = command.count.value_or(1);
  std::vector<Genotype> genotypes;
  for (int i = 0; i < count; ++i) {
    Rng rng({*command.seed, 0, static_cast<std::uint64_t>(i),
             Purpose::kInitialise});
    genotypes.push_back(Initialise(options, rng));
    genotypes.back().name = fmt::format("random_{}", *command.seed);
    if (count > 1) genotypes.back().name += fmt::format("_{}", i + 1);
  }
  return genotypes;
}

/// As a run of the experiment begins.
Expected<std::vector<Genotype>, Exit> DrawPopulation(
    const RandomCommand& command, Io& io) {
  auto experiment = LoadExperiment(command.experiment, io);
  if (!experiment) return Exit::kBadInput;
  if (command.seed) experiment->seed = *command.seed;
  const int count = command.count.value_or(experiment->population);
  if (count > experiment->population) {
    io.err << fmt::format(
        "plsc: --count {}: the experiment begins with a population of {}\n"
        "see 'plsc random --help'\n",
        count, experiment->population);
    return Exit::kBadUsage;
  }
  std::vector<Genotype> genotypes;
  for (int id = 1; id <= count; ++id)
    genotypes.push_back(CreateFirst(*experiment, id).genotype);
  return genotypes;
}

Expected<std::vector<Genotype>, Exit> Draw(const RandomCommand& command,
                                           Io& io) {
  if (!command.experiment.empty()) return DrawPopulation(command, io);
  if (command.seed) return DrawSome(command);
  io.err << "plsc: --seed or --experiment is required\n"
            "see 'plsc random --help'\n";
  return Exit::kBadUsage;
}

}  // namespace

Exit Run(const RandomCommand& command, Io& io) {
  const auto drawn = Draw(command, io);
  if (!drawn) return drawn.error();
  std::vector<std::string> texts;
  for (const Genotype& one : *drawn) texts.push_back(Print(one));
  const std::string text = JoinGenotypes(texts);
  // A name such as `rule` or `2nd` for a state comes from the command line;
  // the language decides whether it is one. The same states for all.
  const Source source("<random genotype>", texts.front());
  const Result<Program> program = Compile(source);
  if (!program) {
    Report(program.diagnostics(), source, io);
    return Exit::kBadUsage;
  }
  const Output output{command.output,
                      OutputKind::kGenotype,
                      command.force,
                      {command.experiment}};
  return WriteOutput(output, text, io) ? Exit::kFine : Exit::kBadInput;
}

}  // namespace plsc::cli
