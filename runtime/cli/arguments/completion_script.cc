#include "runtime/cli/arguments/completion_script.h"

#include <fmt/format.h>

#include <algorithm>

namespace plsc::cli {

namespace {

std::vector<std::string> NamesOf(const CommandDescription& command) {
  std::vector<std::string> names;
  for (const OptionDescription& option : command.options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

std::vector<std::string> CommandsBelow(const CommandDescription& command) {
  std::vector<std::string> names;
  for (const CommandDescription& below : command.commands)
    names.push_back(LastWord(below.name));
  return names;
}

// Help texts have no quotes that matter to shells but these.
std::string Backslashed(const std::string& text, const std::string& special) {
  std::string escaped;
  for (const char c : text) {
    if (special.find(c) != std::string::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

// In single quotes of bash and zsh.
std::string SingleQuoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text)
    if (c == '\'')
      quoted += "'\\''";
    else
      quoted += c;
  return quoted + "'";
}

// A command's name as the script's state: "/study/run".
std::string PathOf(const std::string& name) {
  if (name.empty()) return "";
  std::string path = "/" + name;
  std::replace(path.begin(), path.end(), ' ', '/');
  return path;
}

const char* BashFiles(ValueKind kind) {
  switch (kind) {
    case ValueKind::kGenotype:
      return "_plsc_files pls";
    case ValueKind::kFile:
      return "_plsc_files";
    case ValueKind::kFolder:
      return "_plsc_folders";
    case ValueKind::kNone:
    case ValueKind::kOther:
    case ValueKind::kChoice:
      break;
  }
  return ":";
}

std::string BashValue(const OptionDescription& option) {
  if (option.kind == ValueKind::kChoice)
    return fmt::format(
        "_plsc_words {}",
        SingleQuoted(fmt::format("{}", fmt::join(option.choices, " "))));
  return BashFiles(option.kind);
}

constexpr const char* kBashHelpers =
    R"(# bash completion for plsc; made by `plsc completion bash`.

_plsc_words() { COMPREPLY=($(compgen -W "$1" -- "$cur")); }

_plsc_folders() {
  local IFS=$'\n'
  compopt -o filenames 2>/dev/null
  COMPREPLY=($(compgen -d -- "$cur"))
}

# Files that end in .$1 and folders; any file without $1.
_plsc_files() {
  local IFS=$'\n'
  compopt -o filenames 2>/dev/null
  if [[ -n ${1-} ]]; then
    COMPREPLY=($(compgen -f -X "!*.$1" -- "$cur") $(compgen -d -- "$cur"))
  else
    COMPREPLY=($(compgen -f -- "$cur"))
  fi
}

_plsc() {
  local cur=${COMP_WORDS[COMP_CWORD]} command= option= i
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; i++)); do
    case "$command/${COMP_WORDS[i]}" in
)";

std::string BashScript(const CommandDescription& root) {
  std::string script = kBashHelpers;
  const auto commands = AllCommands(root);
  for (const CommandDescription* command : commands)
    if (!command->name.empty())
      script += fmt::format("      {}) command={} ;;\n", PathOf(command->name),
                            PathOf(command->name));
  script +=
      "    esac\n"
      "  done\n"
      "  # --option value and --option=value, which bash splits at '='.\n"
      "  if [[ $cur == '=' ]]; then\n"
      "    option=${COMP_WORDS[COMP_CWORD-1]} cur=\n"
      "  elif ((COMP_CWORD > 1)) && [[ ${COMP_WORDS[COMP_CWORD-1]} == '=' ]]; "
      "then\n"
      "    option=${COMP_WORDS[COMP_CWORD-2]}\n"
      "  elif ((COMP_CWORD > 0)); then\n"
      "    option=${COMP_WORDS[COMP_CWORD-1]}\n"
      "  fi\n"
      "  case \"$command $option\" in\n";
  for (const CommandDescription* command : commands)
    for (const OptionDescription& option : command->options) {
      if (option.kind == ValueKind::kNone) continue;
      std::vector<std::string> patterns;
      for (const std::string& name : option.names)
        patterns.push_back(
            fmt::format("\"{} {}\"", PathOf(command->name), name));
      script += fmt::format("    {}) {}; return ;;\n",
                            fmt::join(patterns, " | "), BashValue(option));
    }
  script += "  esac\n  case \"$command\" in\n";
  for (const CommandDescription* command : commands) {
    std::string otherwise = ":";
    if (!command->commands.empty())
      otherwise =
          "_plsc_words " + SingleQuoted(fmt::format(
                               "{}", fmt::join(CommandsBelow(*command), " ")));
    else if (!command->positionals.empty())
      otherwise = BashValue(command->positionals.front());
    script += fmt::format(
        "    \"{}\")\n"
        "      if [[ $cur == -* ]]; then _plsc_words '{}'\n"
        "      else {}; fi ;;\n",
        PathOf(command->name), fmt::join(NamesOf(*command), " "), otherwise);
  }
  return script + "  esac\n}\n\ncomplete -F _plsc plsc\n";
}

std::string ZshValue(const OptionDescription& option) {
  switch (option.kind) {
    case ValueKind::kChoice:
      return fmt::format(":({})", fmt::join(option.choices, " "));
    case ValueKind::kGenotype:
      return ":_files -g \"*.pls(-.)\"";
    case ValueKind::kFile:
      return ":_files";
    case ValueKind::kFolder:
      return ":_files -/";
    case ValueKind::kNone:
    case ValueKind::kOther:
      break;
  }
  return ": ";
}

std::string ZshOption(const OptionDescription& option) {
  std::string specs;
  for (const std::string& name : option.names) {
    std::string spec = option.is_repeated ? "*" : "";
    spec += name + "[" + Backslashed(option.help, "[]:\\") + "]";
    if (option.kind != ValueKind::kNone)
      spec += ":" + Backslashed(option.value, ":\\") + ZshValue(option);
    specs += " \\\n        " + SingleQuoted(spec);
  }
  return specs;
}

// Of one command, indented for a case of the function.
std::string ZshArguments(const CommandDescription& command) {
  std::string text = "      _arguments";
  for (const OptionDescription& option : command.options)
    text += ZshOption(option);
  for (const OptionDescription& positional : command.positionals) {
    const std::string spec = (positional.is_repeated ? "*:" : ":") +
                             Backslashed(positional.value, ":\\") +
                             ZshValue(positional);
    text += " \\\n        " + SingleQuoted(spec);
  }
  return text + "\n";
}

// A function that completes the commands below `command` and hands over to
// theirs.
std::string ZshFunction(const CommandDescription& command,
                        const std::string& name) {
  std::string text = name +
                     "() {\n"
                     "  local curcontext=$curcontext state line\n"
                     "  _arguments -C";
  for (const OptionDescription& option : command.options)
    text += ZshOption(option);
  text +=
      " \\\n        '1: :->command' '*:: :->arguments'\n"
      "  case $state in\n"
      "    command)\n"
      "      local -a commands=(\n";
  for (const CommandDescription& below : command.commands)
    text += fmt::format("        {}\n",
                        SingleQuoted(LastWord(below.name) + ":" +
                                     Backslashed(below.summary, ":\\")));
  text +=
      "      )\n"
      "      _describe command commands ;;\n"
      "    arguments)\n"
      "      case $line[1] in\n";
  std::string others;
  for (const CommandDescription& below : command.commands) {
    text += fmt::format("    {})\n", LastWord(below.name));
    if (below.commands.empty()) {
      text += ZshArguments(below);
    } else {
      const std::string other = name + "_" + LastWord(below.name);
      text += "      " + other + "\n";
      others += ZshFunction(below, other);
    }
    text += "      ;;\n";
  }
  return others + text + "      esac ;;\n  esac\n}\n\n";
}

std::string ZshScript(const CommandDescription& root) {
  return "#compdef plsc\n# Made by `plsc completion zsh`.\n\n" +
         ZshFunction(root, "_plsc") +
         "if [ \"$funcstack[1]\" = _plsc ]; then\n"
         "  _plsc \"$@\"\nelse\n  compdef _plsc plsc\nfi\n";
}

std::string FishQuoted(const std::string& text) {
  return "'" + Backslashed(text, "\\'") + "'";
}

// Where a command's completions apply.
std::string FishCondition(const CommandDescription& command) {
  if (command.name.empty()) return "__fish_use_subcommand";
  std::string condition;
  std::string rest = command.name + ' ';
  while (!rest.empty()) {
    const std::size_t end = rest.find(' ');
    if (!condition.empty()) condition += "; and ";
    condition += "__fish_seen_subcommand_from " + rest.substr(0, end);
    rest = rest.substr(end + 1);
  }
  if (!command.commands.empty())
    condition += fmt::format("; and not __fish_seen_subcommand_from {}",
                             fmt::join(CommandsBelow(command), " "));
  return condition;
}

std::string FishValue(const OptionDescription& option) {
  switch (option.kind) {
    case ValueKind::kChoice:
      return " -x -a " +
             FishQuoted(fmt::format("{}", fmt::join(option.choices, " ")));
    case ValueKind::kGenotype:
      return " -k -x -a '(__fish_complete_suffix .pls)'";
    case ValueKind::kFile:
      return " -r -F";
    case ValueKind::kFolder:
      return " -x -a '(__fish_complete_directories)'";
    case ValueKind::kOther:
      return " -x";
    case ValueKind::kNone:
      break;
  }
  return "";
}

std::string FishScript(const CommandDescription& root) {
  std::string script =
      "# fish completion for plsc; made by `plsc completion fish`.\n"
      "complete -c plsc -f\n";
  for (const CommandDescription* command : AllCommands(root)) {
    const std::string start =
        "complete -c plsc -n " + FishQuoted(FishCondition(*command));
    for (const CommandDescription& below : command->commands)
      script += fmt::format("{} -a {} -d {}\n", start, LastWord(below.name),
                            FishQuoted(below.summary));
    for (const OptionDescription& option : command->options) {
      script += start;
      for (const std::string& name : option.names)
        script += name.starts_with("--") ? " -l " + name.substr(2)
                                         : " -s " + name.substr(1);
      script += FishValue(option) + " -d " + FishQuoted(option.help) + '\n';
    }
    if (!command->positionals.empty()) {
      const OptionDescription& first = command->positionals.front();
      if (first.kind != ValueKind::kOther)
        script += start + FishValue(first) + '\n';
    }
  }
  return script;
}

}  // namespace

std::string CompletionScript(const CommandDescription& root, Shell shell) {
  switch (shell) {
    case Shell::kBash:
      return BashScript(root);
    case Shell::kZsh:
      return ZshScript(root);
    case Shell::kFish:
      break;
  }
  return FishScript(root);
}

}  // namespace plsc::cli
