#include "runtime/develop/regulate.h"

#include <fmt/format.h>

#include <ostream>

#include "runtime/cli/arguments/robots.h"
#include "runtime/cli/files/load_program.h"
#include "runtime/history/regulation_json.h"
#include "runtime/history/regulation_text.h"

namespace plsc::cli {

namespace {

Exit PrintTable(const LoadedProgram& loaded, OutputFormat format, Io& io) {
  const Genotype& genotype = loaded.mapped.program.genotype;
  const StateSpace space(genotype);
  if (!space.size()) {
    io.err << fmt::format(
        "error: the clauses tell apart more than {} environments\n"
        "  = help: ask about some of them with --env\n",
        StateSpace::kMaxCombinations);
    return Exit::kBadInput;
  }
  if (format == OutputFormat::kJson) {
    for (int i = 0; i < *space.size(); ++i)
      io.out << RegulationRowJson(genotype, space, i) << '\n';
    return Exit::kFine;
  }
  io.out << RegulationTable(genotype, space) << '\n'
         << RuleLegend(loaded.mapped, loaded.source);
  return Exit::kFine;
}

}  // namespace

Exit Run(const RegulateCommand& command, Io& io) {
  const auto loaded = LoadWithMap(command.file, command.allow_range, io);
  if (!loaded) return Exit::kBadInput;
  if (command.table) return PrintTable(*loaded, command.format, io);
  const Program& program = loaded->mapped.program;
  const auto environments =
      ChooseEnvironments(program, command.environments, io);
  if (!environments) return Exit::kBadUsage;
  for (const NamedEnvironment& named : *environments) {
    if (command.format == OutputFormat::kJson)
      io.out << RegulationJson(program.genotype, named) << '\n';
    else
      io.out << RegulationText(program.genotype, named) << '\n';
  }
  return Exit::kFine;
}

}  // namespace plsc::cli
