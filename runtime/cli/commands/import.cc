#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <utility>

#include "compiler/compile.h"
#include "compiler/print.h"
#include "grammar/keywords.h"
#include "runtime/authors/genotype.h"
#include "runtime/cli/arguments/genotypes.h"
#include "runtime/cli/files/output_path.h"

namespace plsc::cli {

namespace {

AuthorsFormat FormatOf(const ImportCommand& command, const Source& source) {
  switch (command.from) {
    case ImportFormat::kRepr:
      return AuthorsFormat::kRepr;
    case ImportFormat::kLines:
      return AuthorsFormat::kLines;
    case ImportFormat::kAuto:
      break;
  }
  return GuessAuthorsFormat(source.text());
}

// "experiments/genotype_robot_12.txt" is genotype_robot_12.
std::string NameOf(const std::string& path) {
  std::string name = std::filesystem::path(path).stem().string();
  for (char& c : name)
    if (!IsWordCharacter(c)) c = '_';
  if (name.empty() || (name[0] >= '0' && name[0] <= '9')) name = '_' + name;
  return IsGenotypeName(name) ? name : name + '_';
}

// One OLD=NEW. What is wrong with it, if anything.
std::string Rename(const std::string& text, Genotype* genotype) {
  const std::size_t mark = text.find('=');
  if (mark == std::string::npos)
    return fmt::format("--rename wants OLD=NEW, not '{}'", text);
  const std::string from = text.substr(0, mark);
  const std::string to = text.substr(mark + 1);
  if (!IsName(to)) return fmt::format("'{}' cannot be the name of a state", to);
  const auto named = [](const std::string& name) {
    return [name](const State& state) { return state.name == name; };
  };
  auto& states = genotype->states;
  const auto found = std::find_if(states.begin(), states.end(), named(from));
  if (found == states.end())
    return fmt::format("no clause of the genotype asks about '{}'", from);
  if (std::any_of(states.begin(), states.end(), named(to)))
    return fmt::format("two states cannot both be called '{}'", to);
  found->name = to;
  return "";
}

Output OutputOf(const ImportCommand& command) {
  return {command.output, OutputKind::kGenotype, command.force, {command.file}};
}

}  // namespace

Exit Run(const ImportCommand& command, Io& io) {
  if (!command.name.empty() && !IsGenotypeName(command.name)) {
    io.err << fmt::format("plsc: '{}' cannot be the name of a genotype\n",
                          command.name);
    return Exit::kBadUsage;
  }
  if (!CanWrite(OutputOf(command), io)) return Exit::kBadInput;
  const auto source = ReadOrReport(command.file, io);
  if (!source) return Exit::kBadInput;
  ImportOptions options;
  options.name = !command.name.empty() ? command.name
                 : command.file == "-" ? "imported"
                                       : NameOf(command.file);
  options.allow_range = command.allow_range;
  options.unjoin = command.unjoin;
  Result<Program> program =
      ImportAuthorsGenotype(*source, FormatOf(command, *source), options);
  Report(program.diagnostics(), *source, io);
  if (!program) return Exit::kBadInput;
  for (const std::string& rename : command.renames) {
    const std::string problem = Rename(rename, &program->genotype);
    if (problem.empty()) continue;
    io.err << "plsc: " << problem << '\n';
    return Exit::kBadUsage;
  }
  return WriteOutput(OutputOf(command), Print(*program), io) ? Exit::kFine
                                                             : Exit::kBadInput;
}

}  // namespace plsc::cli
