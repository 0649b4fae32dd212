#include "runtime/cli/robots/robot_source.h"

#include <fmt/format.h>

#include <cassert>
#include <ostream>
#include <utility>

#include "compiler/print.h"
#include "grammar/shown_line.h"
#include "runtime/cli/files/load_yaml.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/life/season_developer.h"
#include "runtime/life/season_environments.h"

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

Expected<RobotFound, Exit> FindInRun(const RobotAsked& asked, Io& io) {
  auto in_store = FindInStore(asked.file, asked.individual, io);
  if (!in_store) return in_store.error();
  auto& [one, scenario] = *in_store;
  // As `plsc show --genotype` prints it, so that its lines are known.
  Source source(one.genotype.name + ".pls", Print(one.genotype));
  CompileOptions options;
  options.allow_out_of_range = true;
  Result<MappedProgram> mapped = CompileWithMap(source, options);
  assert(mapped && mapped->program.genotype == one.genotype);
  RobotFound found{
      fmt::format("{} of generation {}", one.genotype.name, one.generation),
      {std::move(source), std::move(*mapped)},
      {},
      std::move(scenario)};
  Program& program = found.loaded.mapped.program;
  program.environments = SeasonsOf(one);
  if (program.environments.empty() && asked.environments.empty() &&
      asked.scenario.empty())
    return Complain(
        fmt::format("robot {} is not evaluated yet, or did not develop; say "
                    "what it senses with --env",
                    one.id),
        io);
  return found;
}

Expected<RobotFound, Exit> FindInFile(const RobotAsked& asked, Io& io) {
  if (!IsRobotNamed(asked.file, "", io)) return Exit::kBadUsage;
  auto loaded = LoadWithMap(asked.file, asked.allow_range, io);
  if (!loaded) return Exit::kBadInput;
  const Program& program = loaded->mapped.program;
  if (!program.genotype.alphabet->is_built_in()) {
    io.err << fmt::format("error: alphabet '{}' has no bodies to show\n",
                          program.genotype.alphabet->name());
    return Exit::kBadInput;
  }
  std::string title = program.genotype.name;
  return RobotFound{std::move(title), std::move(*loaded), {}, {}};
}

/// The scenario's seasons for what the file declares or the run has stored.
bool PutInto(const RobotAsked& asked, RobotFound& robot, Io& io) {
  Program& program = robot.loaded.mapped.program;
  robot.scenario = LoadScenario(asked.scenario, io);
  if (!robot.scenario || !UseEngine(asked.engine, *robot.scenario, io) ||
      !CanLive(*robot.scenario, program.genotype, io))
    return false;
  program.environments = SeasonEnvironments(program.genotype, *robot.scenario);
  return true;
}

}  // namespace

Expected<RobotOfRun, Exit> FindInStore(const std::string& run,
                                       const std::string& individual, Io& io) {
  RunStore store;
  if (const auto failure = store.OpenForReading(run))
    return Complain(*failure, io);
  const Expected<int, Failure> id = IdOf(store, individual);
  if (!id) return Complain(id.error(), io);
  Expected<Individual, Failure> one = store.FindFirstLife(*id);
  if (!one) return Complain(one.error(), io);
  return RobotOfRun{std::move(*one), store.experiment().scenario};
}

bool IsRobotNamed(const std::string& file, const std::string& individual,
                  Io& io) {
  if (!individual.empty() || !IsDatabase(file)) return true;
  io.err << fmt::format(
      "error: {} is a run; which of its robots? add a number, or best\n",
      Escaped(file));
  return false;
}

Expected<RobotFound, Exit> FindRobot(const RobotAsked& asked, Io& io) {
  auto found =
      asked.individual.empty() ? FindInFile(asked, io) : FindInRun(asked, io);
  if (!found) return found;
  RobotFound& robot = *found;
  const bool is_fine =
      asked.scenario.empty()
          ? !robot.scenario || UseEngine(asked.engine, *robot.scenario, io)
          : PutInto(asked, robot, io);
  if (!is_fine) return Exit::kBadInput;
  auto environments =
      ChooseEnvironments(robot.loaded.mapped.program, asked.environments, io);
  if (!environments) return Exit::kBadUsage;
  robot.environments = std::move(*environments);
  return found;
}

bool CanLive(const Scenario& scenario, const Genotype& genotype, Io& io) {
  if (!genotype.alphabet->is_built_in()) {
    io.err << fmt::format("error: alphabet '{}' has no bodies to simulate\n",
                          genotype.alphabet->name());
    return false;
  }
  const std::vector<Diagnostic> problems =
      CheckSenses(scenario, genotype.states);
  for (const Diagnostic& problem : problems)
    io.err << fmt::format("error: {}\n", Escaped(problem.message));
  return problems.empty();
}

}  // namespace plsc::cli
