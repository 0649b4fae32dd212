#include <fmt/format.h>

#include <filesystem>
#include <ostream>

#include "runtime/cli/commands.h"
#include "runtime/cli/load_yaml.h"
#include "runtime/cli/program.h"
#include "runtime/evaluation.h"
#include "runtime/formats/season_json.h"
#include "runtime/formats/trajectory_csv.h"

namespace plsc::cli {

namespace {

// Every season must say what the genotype senses and cannot feel, before any
// is simulated.
bool CanSense(const Scenario& scenario, const Genotype& genotype, Io& io) {
  const std::vector<Diagnostic> problems =
      CheckSenses(scenario, genotype.states);
  for (const Diagnostic& problem : problems)
    io.err << fmt::format("error: {}\n", problem.message);
  return problems.empty();
}

void PrintHeader(std::ostream& out) {
  out << fmt::format("{:<12} {:>5} {:>6} {:>7} {:>11} {:>8} {:>9}  {}\n",
                     "season", "size", "joints", "sensors", "speed cm/s",
                     "balance", "fitness", "outcome");
}

void PrintRow(const SeasonResult& result, std::ostream& out) {
  constexpr double kCentimetres = 100;  // the paper's unit of Speed
  const std::string speed =
      result.behaviour.is_valid
          ? fmt::format(
                "{:.3f}",
                kCentimetres * result.behaviour.displacement_velocity_hill)
          : "-";
  const std::string balance =
      result.behaviour.is_valid
          ? fmt::format("{:.4f}", result.behaviour.head_balance)
          : "-";
  const std::string fitness =
      result.fitness ? fmt::format("{:.5f}", *result.fitness) : "none";
  out << fmt::format("{:<12} {:>5} {:>6} {:>7} {:>11} {:>8} {:>9}  {}\n",
                     result.season, result.body.absolute_size,
                     result.body.hinge_count, result.body.touch_sensor_count,
                     speed, balance, fitness, OutcomeName(result.outcome));
  if (!result.reason.empty())
    out << fmt::format("  {}: {}\n", OutcomeName(result.outcome),
                       result.reason);
}

// When and why the robot is what it is.
void PrintChange(const SeasonResult& result, const Scenario& scenario,
                 std::ostream& out) {
  if (result.outcome == Outcome::kNotReached ||
      result.outcome == Outcome::kUndeveloped)
    return;
  const std::string when = scenario.lives == Lives::kContinuous
                               ? fmt::format(" at {} s", result.begin)
                               : "";
  const char* what = result.change == Change::kBorn   ? "born"
                     : result.change == Change::kNone ? "the same robot"
                     : result.change == Change::kBrain
                         ? "the same body, another brain"
                         : "another body";
  out << fmt::format("  {}{}: {}\n", what, when, result.change_reason);
}

std::vector<NamedValue> DescriptorsOf(const SeasonResult& result) {
  std::vector<NamedValue> all = List(result.behaviour);
  for (const NamedValue& value : List(result.body)) all.push_back(value);
  for (const NamedValue& value : List(result.brain)) all.push_back(value);
  return all;
}

// One descriptor a line, one season a column, under the authors' names.
void PrintDescriptors(const std::vector<SeasonResult>& results,
                      std::ostream& out) {
  out << fmt::format("\n{:<28}", "descriptor");
  std::vector<std::vector<NamedValue>> columns;
  for (const SeasonResult& result : results) {
    out << fmt::format(" {:>12}", result.season);
    columns.push_back(DescriptorsOf(result));
  }
  out << '\n';
  for (std::size_t row = 0; row < columns.front().size(); ++row) {
    out << fmt::format("{:<28}", columns.front()[row].name);
    for (const auto& column : columns)
      out << fmt::format(" {:>12.6g}", column[row].value);
    out << '\n';
  }
}

bool WriteInto(const std::string& folder, const std::string& name,
               const std::string& text, Io& io) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const std::string path = (std::filesystem::path(folder) / name).string();
  const auto failure = WriteFile(path, text);
  if (failure)
    io.err << fmt::format("error: cannot write '{}': {}\n", path, *failure);
  else
    io.err << fmt::format("wrote {}\n", path);
  return !failure;
}

}  // namespace

Exit Run(const SimulateCommand& command, Io& io) {
  const auto program = LoadProgram(command.file, false, io);
  if (!program) return Exit::kBadInput;
  const Genotype& genotype = program->genotype;
  if (!genotype.alphabet->is_built_in()) {
    io.err << fmt::format("error: alphabet '{}' has no bodies to simulate\n",
                          genotype.alphabet->name());
    return Exit::kBadInput;
  }
  const auto scenario = LoadScenario(command.scenario, io);
  if (!scenario || !CanSense(*scenario, genotype, io)) return Exit::kBadInput;

  if (command.format == OutputFormat::kText) {
    io.out << fmt::format(
        "{} in scenario {} (profile {})\n", genotype.name,
        scenario->name.empty() ? "of no name" : scenario->name,
        ProfileName(scenario->profile));
    PrintHeader(io.out);
  }
  // Samples mean nothing without the constants that they were made with.
  const std::string& folder = command.trajectory_folder;
  if (!folder.empty() &&
      !WriteInto(folder, "scenario.yaml", PrintScenario(*scenario), io))
    return Exit::kBadInput;
  std::vector<SeasonResult> results;
  for (Life lives(genotype, *scenario); !lives.is_over();) {
    const SeasonLife life = lives.Next();
    if (command.format == OutputFormat::kText) {
      PrintRow(life.result, io.out);
      PrintChange(life.result, *scenario, io.out);
    } else {
      io.out << SeasonJson(genotype.name, life.result) << '\n';
    }
    io.out.flush();  // a season takes a while; show each when it is done
    if (!folder.empty() && !WriteInto(folder, life.result.season + ".csv",
                                      TrajectoryCsv(life.trajectory), io))
      return Exit::kBadInput;
    results.push_back(life.result);
  }
  if (command.descriptors && command.format == OutputFormat::kText)
    PrintDescriptors(results, io.out);
  return Exit::kFine;
}

}  // namespace plsc::cli
