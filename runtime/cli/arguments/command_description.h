#pragma once

// The command line as data: what completions and manual pages are made of.
// Read from the one place where commands, options and help are written, the Add
// functions.

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/cli/arguments/registry.h"

namespace plsc::cli {

/// What a value is, for shells that complete it.
enum class ValueKind : std::uint8_t {
  kNone,      ///< the option takes no value
  kOther,     ///< a number, a name
  kChoice,    ///< one of OptionDescription::choices
  kGenotype,  ///< a .pls file
  kFile,
  kFolder,
};

struct OptionDescription {
  std::vector<std::string> names;  ///< "-o", "--output"; empty: positional
  std::string value;               ///< "FILE", "text|json"; empty: none
  std::string help;
  ValueKind kind = ValueKind::kNone;
  std::vector<std::string> choices;
  bool is_required = false;
  bool is_repeated = false;
  int values_at_once = 0;  ///< of a named option: at most, each time
};

struct CommandDescription {
  std::string name;     ///< "study run"; empty: plsc itself
  std::string summary;  ///< a line without a stop
  std::string footer;   ///< prose, and examples behind two blanks
  std::vector<OptionDescription> options;
  std::vector<OptionDescription> positionals;
  std::vector<CommandDescription> commands;
};

/// `plsc` with all its commands.
CommandDescription DescribeCommandLine(const Registry& registry = Commands());

/// `app` and all below it; `name` as in CommandDescription.
CommandDescription DescribeApp(const CLI::App& app, const std::string& name);

/// `root` and all commands below it, each before its own.
std::vector<const CommandDescription*> AllCommands(
    const CommandDescription& root);

/// "run" of "study run".
std::string LastWord(const std::string& name);

}  // namespace plsc::cli
