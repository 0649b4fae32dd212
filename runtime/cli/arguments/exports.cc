// Options and help of the command that writes files for other programs.

#include <CLI/CLI.hpp>
#include <algorithm>

#include "runtime/cli/arguments/add_commands.h"

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
void AddRobotOptions(CLI::App* sub, ExportCommand& command, CLI::Option* to) {
  sub->add_option("ROBOT,--individual", command.individual,
                  "with --to: which robot of the run, a number or best")
      ->option_text("ROBOT")
      ->needs(to);
  sub->add_option("--env", command.environments,
                  "with --to: what the robot senses, STATE=VALUE,... or the "
                  "name of an environment of the file, of a season of the "
                  "run; may be repeated (default: all of them)")
      ->option_text("ENVIRONMENT")
      ->needs(to);
  sub->add_option("--scenario", command.scenario,
                  "with --to: YAML file with the seasons and the physics "
                  "(default: of a robot of a run the run's; of a file flat "
                  "ground and the paper's constants)")
      ->option_text("FILE")
      ->needs(to);
  sub->add_flag("--alone", command.alone,
                "with --to mjcf or sdf: the robot without ground, light and "
                "physics, for a world of yours")
      ->needs(to);
  sub->add_option("--prefix", command.prefix,
                  "with --to: goes before the names of all parts, so that one "
                  "world takes several robots")
      ->option_text("TEXT")
      ->check(CheckPrefix)
      ->needs(to);
  sub->add_flag("--allow-range", command.allow_range,
                "with --to: arguments outside their range are warnings, not "
                "errors")
      ->needs(to);
}

}  // namespace

CLI::App* AddExport(CLI::App& app, ExportCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "export", "Write robots or runs as files for other programs");
  sub->add_option("FILE", command.file,
                  "the store that plsc evolve made; for --to a genotype file "
                  "(- is standard input), too")
      ->required();
  CLI::Option* to = sub->add_option_function<std::string>(
                           "--to",
                           [&command](const std::string& name) {
                             command.to = FormatOf(name)->format;
                           },
                           "a robot, as " + FormatList())
                        ->check(CheckExportFormat)
                        ->option_text("FORMAT");
  CLI::Option* csv =
      sub->add_option("--csv", command.csv_folder,
                      "a run, a table a file, with a header, into this folder")
          ->option_text("FOLDER")
          ->excludes(to);
  sub->add_flag("--jsonl", command.jsonl,
                "a run, one JSON object a line: the run, its individuals with "
                "their seasons, its generations")
      ->excludes(csv)
      ->excludes(to);
  AddRobotOptions(sub, command, to);
  sub->add_option("-o,--output", command.output,
                  "file for --to or --jsonl (default: standard output), or a "
                  "folder for the robots of several environments")
      ->option_text("FILE|FOLDER")
      ->excludes(csv);
  AddForce(sub, command.force);
  sub->footer(kExportFooter);
  return sub;
}

}  // namespace plsc::cli
