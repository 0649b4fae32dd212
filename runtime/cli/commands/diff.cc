#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <utility>

#include "compiler/compile.h"
#include "compiler/environment_text.h"
#include "grammar/shown_line.h"
#include "runtime/cli/arguments/git.h"
#include "runtime/cli/files/load_program.h"
#include "runtime/compare/difference_text.h"
#include "runtime/compare/version_difference.h"
#include "runtime/text/unified_diff.h"

namespace plsc::cli {

namespace {

bool IsGitsNothing(const std::string& path, const DiffCommand& command) {
  return command.is_git && path == "/dev/null";
}

// Prints what is wrong, of git's temporary files under `git_name`.
std::optional<FileVersion> ReadVersion(const std::string& path,
                                       const std::string& git_name,
                                       const DiffCommand& command, Io& io) {
  if (IsGitsNothing(path, command))
    return FileVersion{Source(path, ""), {}, ""};
  // Names of git's temporary files are no GenotypePath.
  const GenotypePath from =
      command.is_git ? GenotypePath{path, ""} : SplitGenotypePath(path);
  std::optional<Source> source = ReadOrReport(from.file, io);
  if (!source) return std::nullopt;
  if (command.is_git) source = Source(git_name, std::string(source->text()));
  CompileOptions options;
  options.allow_out_of_range = command.allow_range;
  auto compiled = CompileAll(*source, options);
  if (!compiled) {
    Report(compiled.diagnostics(), *source, io);
    return std::nullopt;
  }
  FileVersion version{std::move(*source), std::move(*compiled), from.genotype};
  if (version.chosen.empty()) return version;
  std::erase_if(version.programs, [&](const Program& program) {
    return program.genotype.name != version.chosen;
  });
  if (!version.programs.empty()) return version;
  io.err << RenderWithoutLine(
      {Code::kSeveralGenotypes,
       {},
       fmt::format("{} has no genotype '{}'", from.file, version.chosen)});
  return std::nullopt;
}

// The environments of --env; prints what is wrong.
std::optional<SharedEnvironments> Chosen(const Program& before,
                                         const Program& after,
                                         const DiffCommand& command, Io& io) {
  const auto old_ones = ChooseEnvironments(before, command.environments, io);
  if (!old_ones) return std::nullopt;
  const auto new_ones = ChooseEnvironments(after, command.environments, io);
  if (!new_ones) return std::nullopt;
  SharedEnvironments shared;
  for (std::size_t i = 0; i < new_ones->size(); ++i)
    shared.environments.push_back({command.environments[i],
                                   {},
                                   (*old_ones)[i].environment,
                                   (*new_ones)[i].environment});
  return shared;
}

std::optional<VersionDifference> Compare(const FileVersion& before,
                                         const FileVersion& after,
                                         const DiffCommand& command, Io& io) {
  return CompareVersions(
      before, after, [&](const Program& then, const Program& now) {
        return command.environments.empty() ? FindSharedEnvironments(then, now)
                                            : Chosen(then, now, command, io);
      });
}

void PrintText(const VersionDifference& comparison, const DiffCommand& command,
               Io& io) {
  DifferenceStyle style;
  style.in_color = command.color == ColorChoice::kAlways ||
                   (command.color == ColorChoice::kAuto && io.out_in_color);
  // Of genotypes that are new, or gone, nobody wants to read every symbol.
  const auto is_whole = [&](const SectionChange& section) {
    const bool is_only =
        section.genotype.empty() && comparison.robots.size() == 1;
    return std::any_of(comparison.robots.begin(), comparison.robots.end(),
                       [&](const GenotypeDifference& one) {
                         return one.kind != ItemChangeKind::kChanged &&
                                (is_only || one.genotype == section.genotype);
                       });
  };
  for (const SectionChange& section : comparison.texts) {
    if (is_whole(section)) continue;
    if (!section.genotype.empty()) io.out << section.genotype << ":\n";
    io.out << ItemChangesText(section.items, style);
  }
  for (const GenotypeDifference& one : comparison.robots) {
    if (one.kind == ItemChangeKind::kAdded)
      io.out << fmt::format("{}: a new genotype\n", one.genotype);
    else if (one.kind == ItemChangeKind::kRemoved)
      io.out << fmt::format("{}: the genotype is gone\n", one.genotype);
    else
      io.out << RobotDifferencesText(one.genotype, one.environments, style);
    if (!one.limitation.empty())
      io.out << fmt::format(
          "{}: not compared in every environment: {}; only in those that both "
          "files name\n",
          one.genotype, one.limitation);
  }
}

// PATH OLD OLD-HASH OLD-MODE NEW NEW-HASH NEW-MODE [NEW-PATH INFORMATION], or
// the PATH alone of a file that is in conflict ("git help diff", GIT_EXTERNAL_
// DIFF). Anything but exit status 0 would end git's own command.
Exit RunForGit(const DiffCommand& command, Io& io) {
  const std::vector<std::string>& given = command.files;
  if (given.size() == 1) {
    io.out << fmt::format("* Unmerged path {}\n", given[0]);
    return Exit::kFine;
  }
  const std::string& path = given[0];
  const std::string& new_path = given.size() > 7 ? given[7] : path;
  io.out << fmt::format("plsc diff a/{} b/{}\n", path, new_path);
  const auto before = ReadVersion(given[1], "a/" + path, command, io);
  const auto after = ReadVersion(given[4], "b/" + new_path, command, io);
  if (before && after) {
    const auto comparison = Compare(*before, *after, command, io);
    if (comparison) PrintText(*comparison, command, io);
    return Exit::kFine;
  }
  const auto text = [&](const std::string& file) -> std::string {
    if (IsGitsNothing(file, command)) return "";
    const auto source = ReadSource(file, io);
    return source ? std::string(source->text()) : "";
  };
  io.out << UnifiedDiff(text(given[1]), text(given[4]), "a/" + path,
                        "b/" + new_path);
  return Exit::kFine;
}

}  // namespace

Exit Run(const DiffCommand& command, Io& io) {
  const std::size_t count = command.files.size();
  if (command.is_git && (count == 1 || count == 7 || count == 9))
    return RunForGit(command, io);
  if (command.is_git || count != 2) {
    io.err << fmt::format(
        "plsc: diff takes {}, not {}\nsee 'plsc diff --help'\n",
        command.is_git ? "1, 7 or 9 arguments from git" : "OLD and NEW", count);
    return Exit::kBadUsage;
  }
  const auto before = ReadVersion(command.files[0], "", command, io);
  const auto after = ReadVersion(command.files[1], "", command, io);
  if (!before || !after) return Exit::kTrouble;
  const auto comparison = Compare(*before, *after, command, io);
  if (!comparison) return Exit::kTrouble;
  if (command.format == OutputFormat::kJson)
    io.out << DifferenceJson(comparison->texts, comparison->robots) << '\n';
  else
    PrintText(*comparison, command, io);
  return comparison->is_different() ? Exit::kDiffers : Exit::kFine;
}

}  // namespace plsc::cli
