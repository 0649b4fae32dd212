#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "compiler/compile.h"
#include "compiler/print.h"
#include "runtime/cli/commands.h"
#include "runtime/cli/output_path.h"
#include "runtime/evolve/initialise.h"
#include "runtime/evolve/rng.h"

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

}  // namespace

Exit Run(const RandomCommand& command, Io& io) {
  Rng rng({command.seed, 0, 0, Purpose::kInitialise});
  Genotype genotype = Initialise(OptionsOf(command), rng);
  genotype.name = fmt::format("random_{}", command.seed);
  const std::string text = Print(genotype);
  // A name such as `rule` or `2nd` for a state comes from the command line;
  // the language decides whether it is one.
  const Source source("<random genotype>", text);
  const Result<Program> program = Compile(source);
  if (!program) {
    Report(program.diagnostics(), source, io);
    return Exit::kBadUsage;
  }
  const Output output{command.output, OutputKind::kGenotype, command.force};
  return WriteOutput(output, text, io) ? Exit::kFine : Exit::kBadInput;
}

}  // namespace plsc::cli
