#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ostream>
#include <utility>

#include "grammar/shown_line.h"
#include "runtime/cli/arguments/robots.h"
#include "runtime/cli/files/load_program.h"
#include "runtime/cli/files/load_yaml.h"
#include "runtime/cli/files/output_path.h"
#include "runtime/cli/robots/recorded_life.h"
#include "runtime/cli/robots/robot_source.h"
#include "runtime/cli/running/interrupt.h"
#include "runtime/life/life.h"
#include "runtime/life/season_json.h"
#include "runtime/pictures/path_svg.h"
#include "runtime/recording/recording_json.h"
#include "runtime/recording/trajectory_csv.h"
#include "runtime/scenario/scenario_yaml.h"
#include "runtime/text/quantity.h"

namespace plsc::cli {

namespace {

void PrintHeader(std::ostream& out) {
  out << fmt::format("{:<12} {:>5} {:>6} {:>7} {:>11} {:>8} {:>9}  {}\n",
                     "season", "size", "joints", "sensors", "speed cm/s",
                     "balance", "fitness", "outcome");
}

void PrintRow(const SeasonResult& result, std::ostream& out) {
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
                     Escaped(result.season), result.body.absolute_size,
                     result.body.hinge_count, result.body.touch_sensor_count,
                     speed, balance, fitness, OutcomeName(result.outcome));
  if (!result.reason.empty())
    out << fmt::format("  {}: {}\n", OutcomeName(result.outcome),
                       Escaped(result.reason));
}

/// What a life was lived by; nothing of ODE, which is the usual.
std::string EngineText(const Scenario& scenario) {
  if (!UsesOde(scenario)) return ", engine articulated";
  Scenario ode = scenario;
  SetEngine(ode, EngineKind::kOde);
  return ode == scenario ? "" : ", both engines";
}

/// How far the solver was from converging, where it may be.
void PrintServos(const SeasonResult& result, const Scenario& scenario,
                 std::ostream& out) {
  const auto season = std::find_if(
      scenario.seasons.begin(), scenario.seasons.end(),
      [&](const Season& one) { return one.name == result.season; });
  if (!result.behaviour.is_valid || result.body.hinge_count == 0 ||
      season == scenario.seasons.end() ||
      season->physics.solver != Solver::kIterative)
    return;
  out << fmt::format(
      "  iterative solver, {} iterations: half of the joints' speeds are "
      "{:.2g} "
      "rad/s or more from what servos are told\n",
      season->physics.solver_iterations, result.behaviour.servo_error_median);
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
  out << fmt::format("  {}{}: {}\n", what, when, Escaped(result.change_reason));
}

// A dash where there is nothing to describe: 0 would be a lie.
std::vector<std::pair<std::string_view, std::string>> DescriptorsOf(
    const SeasonResult& result) {
  std::vector<std::pair<std::string_view, std::string>> all;
  const auto add = [&](const std::vector<NamedValue>& values, bool is_known) {
    for (const NamedValue& value : values)
      all.emplace_back(value.name, is_known && !std::isnan(value.value)
                                       ? fmt::format("{:.6g}", value.value)
                                       : "-");
  };
  const bool has_robot = result.body.absolute_size > 0;
  add(List(result.behaviour), result.behaviour.is_valid);
  add(List(result.body), has_robot);
  add(List(result.brain), has_robot);
  return all;
}

// One descriptor a line, one season a column, under the authors' names.
void PrintDescriptors(const std::vector<SeasonResult>& results,
                      std::ostream& out) {
  out << fmt::format("\n{:<28}", "descriptor");
  std::vector<decltype(DescriptorsOf(results.front()))> columns;
  for (const SeasonResult& result : results) {
    out << fmt::format(" {:>12}", Escaped(result.season));
    columns.push_back(DescriptorsOf(result));
  }
  out << '\n';
  for (std::size_t row = 0; row < columns.front().size(); ++row) {
    out << fmt::format("{:<28}", columns.front()[row].first);
    for (const auto& column : columns)
      out << fmt::format(" {:>12}", column[row].second);
    out << '\n';
  }
}

bool Write(const Output& output, const std::string& text, Io& io) {
  if (!WriteOutput(output, text, io)) return false;
  io.err << fmt::format("wrote {}\n", Escaped(output.path));
  return true;
}

// A file that the command was asked for, `path` is one of its options.
Output OutputOf(const SimulateCommand& command, const std::string& path,
                OutputKind kind) {
  return {path,
          kind,
          command.force,
          {SplitGenotypePath(command.file).file, command.scenario}};
}

Output InFolder(const SimulateCommand& command, const std::string& name,
                OutputKind kind) {
  const std::filesystem::path folder = command.trajectory_folder;
  return OutputOf(command, (folder / name).string(), kind);
}

Output SamplesOf(const SimulateCommand& command, const std::string& season) {
  return InFolder(command, season + ".csv", OutputKind::kTrajectory);
}

Output ConstantsOf(const SimulateCommand& command) {
  return InFolder(command, "scenario.yaml", OutputKind::kScenario);
}

// Whether all that the command will write can be written.
bool CanWriteAll(const SimulateCommand& command, const Scenario& scenario,
                 Io& io) {
  if (!CanWrite(OutputOf(command, command.record, OutputKind::kRecording),
                io) ||
      !CanWrite(OutputOf(command, command.svg, OutputKind::kSvg), io))
    return false;
  if (command.trajectory_folder.empty()) return true;
  return MakeFolder(command.trajectory_folder, io) &&
         CanWrite(ConstantsOf(command), io) &&
         std::all_of(scenario.seasons.begin(), scenario.seasons.end(),
                     [&](const Season& season) {
                       return CanWrite(SamplesOf(command, season.name), io);
                     });
}

// Everything that a run of the command leaves behind.
struct Record {
  std::vector<SeasonResult> results;
  Recording recording;
  bool is_written = true;  // so far
};

void PrintSeason(const SimulateCommand& command, const SeasonLife& life,
                 const Scenario& scenario, const Genotype& genotype, Io& io) {
  if (command.format == OutputFormat::kText) {
    PrintRow(life.result, io.out);
    PrintChange(life.result, scenario, io.out);
    PrintServos(life.result, scenario, io.out);
  } else {
    io.out << SeasonJson(genotype, life.result) << '\n';
  }
  io.out.flush();  // a season takes a while; show each when it is done
}

/// Who lives, and where.
struct ToLive {
  Genotype genotype;
  Scenario scenario;
  Circumstances circumstances;
};

Expected<ToLive, Exit> FindInRun(const SimulateCommand& command, Io& io) {
  auto found = FindInStore(command.file, command.individual, io);
  if (!found) return found.error();
  auto& [one, scenario] = *found;
  if (command.scenario.empty())
    return ToLive{
        std::move(one.genotype),
        std::move(scenario),
        {std::move(one.heritage.senses), std::move(one.disturbances)}};
  // Another world is another life, without parents.
  auto other = LoadScenario(command.scenario, io);
  if (!other) return Exit::kBadInput;
  return ToLive{std::move(one.genotype), std::move(*other), {}};
}

Expected<ToLive, Exit> Find(const SimulateCommand& command, Io& io) {
  if (!command.individual.empty()) return FindInRun(command, io);
  if (!IsRobotNamed(command.file, "", io)) return Exit::kBadUsage;
  auto program = LoadProgram(command.file, false, io);
  if (!program) return Exit::kBadInput;
  auto scenario = LoadScenario(command.scenario, io);
  if (!scenario) return Exit::kBadInput;
  return ToLive{std::move(program->genotype), std::move(*scenario), {}};
}

Record LiveAll(const SimulateCommand& command, const ToLive& one, Io& io) {
  const auto& [genotype, scenario, circumstances] = one;
  const bool is_recording = !command.record.empty() || !command.svg.empty();
  RecordedLife lived(genotype, scenario, circumstances, is_recording, io);
  Record record;
  while (!lived.is_over()) {
    const SeasonLife life = lived.Next();
    PrintSeason(command, life, scenario, genotype, io);
    if (!command.trajectory_folder.empty() &&
        !Write(SamplesOf(command, life.result.season),
               TrajectoryCsv(life.trajectory), io))
      record.is_written = false;
    record.results.push_back(life.result);
    if (!record.is_written || InterruptHandler::is_interrupted()) break;
  }
  record.recording = lived.recording();
  return record;
}

}  // namespace

Exit Run(const SimulateCommand& command, Io& io) {
  auto found = Find(command, io);
  if (!found) return found.error();
  if (!UseEngine(command.engine, found->scenario, io)) return Exit::kBadInput;
  const auto& [genotype, scenario, circumstances] = *found;
  if (!CanLive(scenario, genotype, io) || !CanWriteAll(command, scenario, io))
    return Exit::kBadInput;

  if (command.format == OutputFormat::kText) {
    io.out << fmt::format(
        "{} in scenario {} (profile {}{})\n", genotype.name,
        scenario.name.empty() ? "of no name" : Escaped(scenario.name),
        NameIn(kProfileNames, scenario.profile), EngineText(scenario));
    PrintHeader(io.out);
  }
  // Samples mean nothing without the constants that they were made with.
  if (!command.trajectory_folder.empty() &&
      !Write(ConstantsOf(command),
             std::string(kScenarioMark) + PrintScenario(scenario), io))
    return Exit::kBadInput;
  const InterruptHandler handler;
  const Record record = LiveAll(command, *found, io);
  if (command.descriptors && command.format == OutputFormat::kText)
    PrintDescriptors(record.results, io.out);
  bool is_written = record.is_written;
  if (!command.record.empty())
    is_written &=
        Write(OutputOf(command, command.record, OutputKind::kRecording),
              RecordingJson(record.recording), io);
  if (!command.svg.empty())
    is_written &= Write(OutputOf(command, command.svg, OutputKind::kSvg),
                        PathSvg(record.recording), io);
  if (!is_written) return Exit::kBadInput;
  return InterruptHandler::is_interrupted() ? Exit::kInterrupted : Exit::kFine;
}

}  // namespace plsc::cli
