#include "runtime/cli/robot_source.h"

#include <fmt/format.h>

#include <cassert>
#include <ostream>
#include <utility>

#include "compiler/print.h"
#include "runtime/cli/open_run.h"
#include "runtime/season_teller.h"

namespace plsc::cli {

namespace {

// Seasons that the robot developed in, under their names.
std::vector<NamedEnvironment> SeasonsOf(const Individual& one) {
  std::vector<NamedEnvironment> seasons;
  for (const SeasonResult& season : one.evaluation.seasons)
    if (season.sensed.size() == one.genotype.states.size() &&
        season.body.absolute_size > 0)
      seasons.push_back(
          {season.season, EnvironmentOf(season.sensed, one.genotype.states)});
  return seasons;
}

std::variant<RobotFound, Exit> FindInRun(const RobotAsked& asked, Io& io) {
  RunStore store;
  if (const auto failure = store.OpenForReading(asked.file))
    return Complain(*failure, io);
  const Loaded<int> id = IdOf(store, asked.individual);
  if (!id) return Complain(id.failure(), io);
  const Loaded<Individual> one = store.Find(*id);
  if (!one) return Complain(one.failure(), io);
  // As `plsc show --genotype` prints it, so that its lines are known.
  Source source(one->genotype.name + ".pls", Print(one->genotype));
  CompileOptions options;
  options.allow_out_of_range = true;
  Result<MappedProgram> mapped = CompileWithMap(source, options);
  assert(mapped && mapped->program.genotype == one->genotype);
  RobotFound found{
      fmt::format("{} of generation {}", one->genotype.name, one->generation),
      {std::move(source), std::move(*mapped)},
      {}};
  Program& program = found.loaded.mapped.program;
  program.environments = SeasonsOf(*one);
  if (program.environments.empty() && asked.environments.empty())
    return Complain(
        fmt::format("robot {} is not evaluated yet, or did not develop; say "
                    "what it senses with --env",
                    *id),
        io);
  auto environments = ChooseEnvironments(program, asked.environments, io);
  if (!environments) return Exit::kBadUsage;
  found.environments = std::move(*environments);
  return found;
}

}  // namespace

std::variant<RobotFound, Exit> FindRobot(const RobotAsked& asked, Io& io) {
  if (!asked.individual.empty()) return FindInRun(asked, io);
  // It would only be called text that is not UTF-8.
  if (IsDatabase(asked.file)) {
    io.err << fmt::format(
        "error: {} is a run; which of its robots? add a number, or best\n",
        asked.file);
    return Exit::kBadUsage;
  }
  auto loaded = LoadWithMap(asked.file, asked.allow_range, io);
  if (!loaded) return Exit::kBadInput;
  const Program& program = loaded->mapped.program;
  if (!program.genotype.alphabet->is_built_in()) {
    io.err << fmt::format("error: alphabet '{}' has no bodies to show\n",
                          program.genotype.alphabet->name());
    return Exit::kBadInput;
  }
  auto environments = ChooseEnvironments(program, asked.environments, io);
  if (!environments) return Exit::kBadUsage;
  std::string title = program.genotype.name;
  return RobotFound{std::move(title), std::move(*loaded),
                    std::move(*environments)};
}

std::string SensesOf(const NamedEnvironment& named,
                     const std::vector<State>& states) {
  std::string senses = PrintEnvironment(named.environment, states);
  return senses == named.name ? std::string() : senses;
}

}  // namespace plsc::cli
