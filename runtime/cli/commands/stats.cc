#include <fmt/format.h>

#include <ostream>

#include "runtime/advice/stats_text.h"
#include "runtime/cli/arguments/genotypes.h"
#include "runtime/cli/files/load_program.h"
#include "runtime/develop/regimes.h"

namespace plsc::cli {

namespace {

// Columns that anybody reads; more environments are better told by their
// names.
constexpr std::size_t kMaxRegimes = 64;

// What --env says, what the file declares, or else the first environment of
// each kind that the clauses tell apart.
std::optional<std::vector<NamedEnvironment>> EnvironmentsOf(
    const Program& program, const std::vector<std::string>& texts, Io& io) {
  const bool is_chosen = !texts.empty() || !program.environments.empty() ||
                         program.genotype.states.empty();
  if (is_chosen) return ChooseEnvironments(program, texts, io);
  const StateSpace space(program.genotype);
  const auto regimes = FindRegimes(ClausesOf(program.genotype), space);
  if (!regimes || regimes->size() > kMaxRegimes)
    return ChooseEnvironments(program, texts, io);
  std::vector<NamedEnvironment> environments;
  for (const Regime& regime : *regimes)
    environments.push_back(
        {space.Describe(regime.environment, program.genotype.states),
         {space.At(regime.environment)}});
  return environments;
}

Exit ReportGenotype(const LoadedFile& file, std::size_t index,
                    const StatsCommand& command, Io& io) {
  const Program& program = file.all[index].program;
  const auto environments = EnvironmentsOf(program, command.environments, io);
  if (!environments) return Exit::kBadUsage;
  const auto stats = StatsOf(program.genotype, *environments);
  if (!stats) {
    ReportGrowth({file.source, file.all[index]},
                 (*environments)[stats.error().environment], io);
    return Exit::kBadInput;
  }
  if (command.format == OutputFormat::kJson)
    io.out << StatsJson(PathOf(file, index), program.genotype, *stats) << '\n';
  else
    io.out << StatsText(program.genotype, *stats) << '\n';
  return Exit::kFine;
}

Exit ReportFile(const std::string& path, const StatsCommand& command, Io& io) {
  const auto file = LoadFile(path, command.allow_range, io);
  if (!file) return Exit::kBadInput;
  Exit worst = Exit::kFine;
  for (const std::size_t index : file->chosen) {
    const Exit exit = ReportGenotype(*file, index, command, io);
    if (exit != Exit::kFine) worst = exit;
  }
  return worst;
}

}  // namespace

Exit Run(const StatsCommand& command, Io& io) {
  Exit worst = Exit::kFine;
  for (const std::string& file : command.files) {
    const Exit exit = ReportFile(file, command, io);
    if (exit != Exit::kFine) worst = exit;
  }
  return worst;
}

}  // namespace plsc::cli
