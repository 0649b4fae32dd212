#include "runtime/cli/commands/export_robot.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <system_error>
#include <utility>

#include "grammar/shown_line.h"
#include "runtime/cli/files/load_program.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/cli/files/output_path.h"
#include "runtime/cli/robots/robot_setting.h"
#include "runtime/cli/robots/robot_source.h"
#include "runtime/develop/develop.h"
#include "runtime/exports/robot_model.h"
#include "sim/overlap.h"

namespace plsc::cli {

namespace {

namespace fs = std::filesystem;

bool IsFileLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '=' ||
         c == ',' || c == '+';
}

// File systems take 255 bytes a name; there is an ending, too.
constexpr std::size_t kLongestWord = 100;

std::string FileWord(const std::string& text) {
  std::string word;
  for (const char c : text) word += IsFileLetter(c) ? c : '_';
  return word.substr(0, kLongestWord);
}

/// A robot whose parts overlap would start with a jerk.
void WarnOfOverlaps(const RobotModel& model, Io& io) {
  const auto overlaps = FindOverlaps(model.assembly);
  if (overlaps.empty()) return;
  const auto box_name = [&](int link, int box) {
    return BoxName(model.phenotype.body,
                   model.assembly.links[static_cast<std::size_t>(link)]
                       .boxes[static_cast<std::size_t>(box)]);
  };
  const Overlap& first = overlaps.front();
  io.err << fmt::format(
      "warning: in {}, {} pairs of parts overlap, first {} and {}: plsc "
      "simulates no such robot, and other programs push them apart\n",
      Escaped(model.environment), overlaps.size(),
      box_name(first.link_a, first.box_a), box_name(first.link_b, first.box_b));
}

/// Once for all robots: what their files do not say.
void WarnOfLeftOut(ExportFormat format, const std::vector<RobotModel>& models,
                   Io& io) {
  std::vector<std::string> parts;
  for (const RobotModel& model : models) {
    const std::string left_out = LeftOut(format, model);
    if (!left_out.empty())
      parts.push_back(
          fmt::format("in {} {}", Escaped(model.environment), left_out));
  }
  if (parts.empty()) return;
  io.err << fmt::format(
      "warning: {} has no place for what plsc simulates: {}\n", NameOf(format),
      fmt::join(parts, "; "));
}

std::optional<std::vector<RobotModel>> GrowModels(const ExportCommand& command,
                                                  const RobotFound& robot,
                                                  Io& io) {
  const Genotype& genotype = robot.loaded.mapped.program.genotype;
  std::vector<RobotSetting> settings = SettingsOf(robot, io);
  // Also of a robot that no scenario gives one.
  for (RobotSetting& setting : settings)
    setting.options.physics.engine =
        command.engine.value_or(setting.options.physics.engine);
  std::vector<RobotModel> models;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const NamedEnvironment& named = robot.environments[i];
    const auto phenotype = Develop(genotype, named.environment);
    if (!phenotype) {
      ReportGrowth(robot.loaded, named, io);
      return std::nullopt;
    }
    models.push_back(ModelOf({genotype.name, named.name, command.prefix},
                             *phenotype, settings[i].options,
                             settings[i].terrain));
    WarnOfOverlaps(models.back(), io);
  }
  if (!command.alone) WarnOfLeftOut(*command.to, models, io);
  return models;
}

struct RobotFile {
  std::string path;
  std::string text;
};

bool AsksFolder(const std::string& path) {
  std::error_code error;
  return path.ends_with('/') || fs::is_directory(path, error);
}

Exit AskForOne(const std::vector<RobotModel>& models, Io& io) {
  std::vector<std::string> names;
  names.reserve(models.size());
  for (const RobotModel& model : models)
    names.push_back(Escaped(model.environment));
  io.err << fmt::format(
      "plsc: {} robots, a file each (in {}); choose one with --env, or name a "
      "folder with -o\nsee 'plsc export --help'\n",
      models.size(), fmt::join(names, ", "));
  return Exit::kBadUsage;
}

/// The folder that a path names or will name, unless something else is there.
bool CanFill(const std::string& folder, Io& io) {
  std::error_code error;
  if (fs::is_directory(folder, error)) return true;
  fs::path path(folder);
  if (!path.has_filename()) path = path.parent_path();  // "robots/"
  const fs::path parent = path.parent_path();
  const char* problem = nullptr;
  if (fs::exists(path, error))
    problem = "it is a file";
  else if (!parent.empty() && !fs::is_directory(parent, error))
    problem = "its folder does not exist";
  if (problem != nullptr)
    io.err << fmt::format("error: cannot make the folder '{}': {}\n", folder,
                          problem);
  return problem == nullptr;
}

Output OutputOf(const ExportCommand& command, const std::string& path) {
  return {path,
          OutputKind::kRobot,
          command.force,
          {SplitGenotypePath(command.file).file}};
}

Exit WriteAll(const std::vector<RobotFile>& files, const ExportCommand& command,
              Io& io) {
  for (const RobotFile& file : files)
    if (!CanWrite(OutputOf(command, file.path), io)) return Exit::kBadInput;
  for (const RobotFile& file : files) {
    if (!WriteOutput(OutputOf(command, file.path), file.text, io))
      return Exit::kBadInput;
    io.err << fmt::format("wrote {}\n", Escaped(file.path));
  }
  return Exit::kFine;
}

std::string TextOf(const ExportCommand& command, const RobotModel& model) {
  return ExportText(*command.to, model,
                    command.alone ? Surroundings::kNone : Surroundings::kFloor);
}

Exit FillFolder(const ExportCommand& command,
                const std::vector<RobotModel>& models, Io& io) {
  if (!CanFill(command.output, io)) return Exit::kBadInput;
  std::vector<std::string> names;
  std::vector<RobotFile> files;
  for (const RobotModel& model : models) {
    names.push_back(ExportedName(model, *command.to, names));
    files.push_back({(fs::path(command.output) / names.back()).string(),
                     TextOf(command, model)});
  }
  std::error_code error;
  const bool is_new = !fs::is_directory(command.output, error);
  if (is_new && !fs::create_directory(command.output, error) && error)
    return Complain(fmt::format("cannot make the folder '{}': {}",
                                command.output, error.message()),
                    io);
  return WriteAll(files, command, io);
}

}  // namespace

std::string ExportedName(const RobotModel& model, ExportFormat format,
                         const std::vector<std::string>& taken) {
  const std::string stem =
      FileWord(model.name) + "." + FileWord(model.environment);
  std::string name = fmt::format("{}.{}", stem, EndingOf(format));
  for (int i = 2; std::count(taken.begin(), taken.end(), name) > 0; ++i)
    name = fmt::format("{}-{}.{}", stem, i, EndingOf(format));
  return name;
}

Exit ExportRobots(const ExportCommand& command, Io& io) {
  const bool asks_folder = AsksFolder(command.output);
  // Several robots would make it a folder, so what --force replaces comes
  // later.
  Output whatever_it_is = OutputOf(command, command.output);
  whatever_it_is.force = true;
  if (!asks_folder && !CanWrite(whatever_it_is, io)) return Exit::kBadInput;
  if (!command.prefix.empty() && !HasNames(*command.to)) {
    io.err << fmt::format(
        "plsc: --prefix goes before names of parts, and {} has none\n"
        "see 'plsc export --help'\n",
        NameOf(*command.to));
    return Exit::kBadUsage;
  }
  const auto found =
      FindRobot({command.file, command.individual, command.environments,
                 command.allow_range, command.scenario, command.engine},
                io);
  if (!found) return found.error();
  const auto models = GrowModels(command, *found, io);
  if (!models) return Exit::kBadInput;
  if (asks_folder) return FillFolder(command, *models, io);
  const bool names_file =
      command.output.ends_with("." + std::string(EndingOf(*command.to)));
  if (models->size() > 1)
    return command.output.empty() || names_file
               ? AskForOne(*models, io)
               : FillFolder(command, *models, io);
  const std::string text = TextOf(command, models->front());
  if (command.output.empty()) {
    io.out << text;
    return Exit::kFine;
  }
  const std::vector<RobotFile> files = {{command.output, text}};
  return WriteAll(files, command, io);
}

}  // namespace plsc::cli
