// From CLI11's description of the commands to our own.

#include <CLI/CLI.hpp>
#include <algorithm>

#include "runtime/cli/arguments/command_description.h"

namespace plsc::cli {

namespace {

std::vector<std::string> Split(const std::string& text, char mark) {
  std::vector<std::string> parts{""};
  for (const char c : text)
    if (c == mark)
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

// "text|json", but not "STUDY|RUN"; or what a check of membership says,
// "TEXT:{baseline,plasticoding}".
std::vector<std::string> ChoicesOf(const CLI::Option& option,
                                   const std::string& value) {
  const std::string type = option.get_type_name();
  const std::size_t open = type.find(":{");
  if (open != std::string::npos && type.ends_with('}'))
    return Split(type.substr(open + 2, type.size() - open - 3), ',');
  const bool is_list = value.find('|') != std::string::npos &&
                       std::all_of(value.begin(), value.end(), [](char c) {
                         return c == '|' || c == '-' || (c >= 'a' && c <= 'z');
                       });
  return is_list ? Split(value, '|') : std::vector<std::string>{};
}

ValueKind KindOf(const OptionDescription& described) {
  if (described.value.empty()) return ValueKind::kNone;
  if (!described.choices.empty()) return ValueKind::kChoice;
  if (described.value == "FOLDER") return ValueKind::kFolder;
  const bool is_genotype =
      described.help.find("genotype file") != std::string::npos &&
      described.help.find("store") == std::string::npos;
  if (described.names.empty() && is_genotype) return ValueKind::kGenotype;
  for (const char* word :
       {"FILE", "RUN", "STUDY", "EXPERIMENT", "INPUT", "PATH"})
    if (described.value.starts_with(word)) return ValueKind::kFile;
  return ValueKind::kOther;
}

OptionDescription Described(const CLI::Option& option) {
  OptionDescription described;
  for (const std::string& name : option.get_snames())
    described.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames())
    described.names.push_back("--" + name);
  described.help = option.get_description();
  described.is_required = option.get_required();
  described.is_repeated =
      option.get_expected_max() > 1 ||
      option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
  described.values_at_once = option.get_allow_extra_args()
                                 ? CLI::detail::expected_max_vector_size
                                 : option.get_items_expected_max();
  const bool takes_value = option.get_items_expected_max() > 0;
  if (takes_value) {
    described.value = option.get_option_text();
    if (described.value.empty())
      described.value = described.names.empty() ? option.get_name() : "VALUE";
    described.choices = ChoicesOf(option, described.value);
  }
  described.kind = KindOf(described);
  return described;
}

}  // namespace

CommandDescription DescribeApp(const CLI::App& app, const std::string& name) {
  CommandDescription command;
  command.name = name;
  command.summary = app.get_description();
  command.footer = app.get_footer();
  for (const CLI::Option* option : app.get_options()) {
    OptionDescription described = Described(*option);
    (described.names.empty() ? command.positionals : command.options)
        .push_back(std::move(described));
  }
  for (const CLI::App* sub : app.get_subcommands({}))
    command.commands.push_back(DescribeApp(
        *sub, name.empty() ? sub->get_name() : name + ' ' + sub->get_name()));
  // `plsc man COMMAND`
  for (CommandDescription& below : command.commands)
    for (OptionDescription& positional : below.positionals)
      if (name.empty() && positional.value == "COMMAND") {
        positional.kind = ValueKind::kChoice;
        for (const CommandDescription& other : command.commands)
          positional.choices.push_back(other.name);
      }
  return command;
}

std::vector<const CommandDescription*> AllCommands(
    const CommandDescription& root) {
  std::vector<const CommandDescription*> all{&root};
  for (const CommandDescription& command : root.commands)
    for (const CommandDescription* below : AllCommands(command))
      all.push_back(below);
  return all;
}

std::string LastWord(const std::string& name) {
  return name.substr(name.rfind(' ') + 1);
}

}  // namespace plsc::cli
