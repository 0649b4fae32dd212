#include "runtime/cli/arguments/exports.h"

#include <algorithm>

#include "runtime/cli/arguments/common_options.h"
#include "runtime/cli/arguments/options.h"

namespace plsc::cli {

namespace {

std::string FormatList() {
  std::string list;
  for (const FormatNames& one : kExportFormats)
    list += (list.empty() ? "" : "|") + std::string(one.name);
  return list;
}

const FormatNames* FormatOf(const std::string& name) {
  const auto* found =
      std::find_if(kExportFormats.begin(), kExportFormats.end(),
                   [&](const FormatNames& one) { return one.name == name; });
  return found == kExportFormats.end() ? nullptr : found;
}

std::string CheckExportFormat(const std::string& name) {
  return FormatOf(name) != nullptr
             ? ""
             : "expected " + FormatList() + ", found '" + name + "'";
}

/// What is part of a name in every format.
std::string CheckPrefix(const std::string& text) {
  const auto is_fine = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
  };
  return !text.empty() && std::all_of(text.begin(), text.end(), is_fine)
             ? ""
             : "expected letters, digits, '_', '-' and '.', found '" + text +
                   "'";
}

constexpr const char* kExportFooter =
    "A robot is written as it develops in an environment, with the geometry, "
    "masses,\ninertias, joints, limits, servos and sensors that plsc "
    "simulates, on the ground of its\nseason and with the constants of its "
    "run or scenario:\n\n"
    "  mjcf             MuJoCo: a world with the robot\n"
    "  urdf             ROS\n"
    "  sdf              Gazebo: a world with the robot\n"
    "  yaml             the authors' program (Revolve)\n"
    "  json             all of it, for programs of yours\n"
    "  controller-json  oscillators, edges, servo and their formulas\n"
    "  controller-c     the same as a C99 header, to run the brain elsewhere\n"
    "\nWithout -o it is printed; several environments need a folder, where "
    "files are\nnamed GENOTYPE.ENVIRONMENT.ENDING. docs/exports.md tells what "
    "each format holds.\n\n"
    "Of a run: works while it goes on, and writes what can be read of a "
    "damaged one\n(exit status 1). Equal runs give equal files. The store is "
    "an SQLite file: sqlite3\nand pandas open it as it is (docs/runs.md).\n\n"
    "  plsc export examples/climber.pls --env flat --to mjcf -o climber.xml\n"
    "  plsc export examples/climber.pls --to sdf -o robots/\n"
    "  plsc export examples/climber.pls --scenario hills.yaml --to json -o "
    "hills/\n"
    "  plsc export run1.sqlite best --to urdf -o best/\n"
    "  plsc export run1.sqlite 7 --env flat --to mjcf --alone --prefix a_\n"
    "  plsc export run1.sqlite --csv tables\n"
    "  plsc export run1.sqlite --jsonl | jq -c 'select(.individual.id == "
    "17)'";

/// What is written of a robot.
void AddRobotOptions(Options& options, ExportCommand& command, Option to) {
  options
      .Add("ROBOT,--individual", command.individual,
           "with --to: which robot of the run, a number or best")
      .ValueName("ROBOT")
      .Needs(to);
  options
      .Add("--env", command.environments,
           "with --to: what the robot senses, STATE=VALUE,... or the "
           "name of an environment of the file, of a season of the "
           "run; may be repeated (default: all of them)")
      .ValueName("ENVIRONMENT")
      .Needs(to);
  options
      .Add("--scenario", command.scenario,
           "with --to: YAML file with the seasons and the physics "
           "(default: of a robot of a run the run's; of a file flat "
           "ground and the paper's constants)")
      .ValueName("FILE")
      .Needs(to);
  AddEngine(options, command.engine, "; with --to").Needs(to);
  options
      .Flag("--alone", command.alone,
            "with --to mjcf or sdf: the robot without ground, light and "
            "physics, for a world of yours")
      .Needs(to);
  options
      .Add("--prefix", command.prefix,
           "with --to: goes before the names of all parts, so that one "
           "world takes several robots")
      .ValueName("TEXT")
      .Check(CheckPrefix)
      .Needs(to);
  options
      .Flag("--allow-range", command.allow_range,
            "with --to: arguments outside their range are warnings, not "
            "errors")
      .Needs(to);
}

}  // namespace

void Add(Options& options, ExportCommand& command) {
  options.Command("export", "Write robots or runs as files for other programs");
  options
      .Add("FILE", command.file,
           "the store that plsc evolve made; for --to a genotype file "
           "(- is standard input), too")
      .Required();
  const Option to = options
                        .Add(
                            "--to",
                            [&command](const std::string& name) {
                              command.to = FormatOf(name)->format;
                            },
                            "a robot, as " + FormatList())
                        .Check(CheckExportFormat)
                        .ValueName("FORMAT");
  const Option csv =
      options
          .Add("--csv", command.csv_folder,
               "a run, a table a file, with a header, into this folder")
          .ValueName("FOLDER")
          .Excludes(to);
  options
      .Flag("--jsonl", command.jsonl,
            "a run, one JSON object a line: the run, its individuals with "
            "their seasons, its generations")
      .Excludes(csv)
      .Excludes(to);
  AddRobotOptions(options, command, to);
  options
      .Add("-o,--output", command.output,
           "file for --to or --jsonl (default: standard output), or a "
           "folder for the robots of several environments")
      .ValueName("FILE|FOLDER")
      .Excludes(csv);
  AddForce(options, command.force);
  options.Footer(kExportFooter);
}

}  // namespace plsc::cli
