#include "runtime/cli/arguments/arguments.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cassert>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <sstream>

#include "grammar/suggest.h"
#include "runtime/cli/arguments/command_description.h"
#include "runtime/cli/files/load_program.h"
#include "runtime/text/version.h"

namespace plsc::cli {

namespace {

constexpr const char* kOverview =
    "Compiler and interpreter of regulated L-systems: genotypes of modular "
    "robots,\nwritten as text, whose rules are switched on and off by what the "
    "robot senses.";

constexpr const char* kFooter =
    "Start here:\n"
    "  plsc check examples/gecko.pls      is the text a genotype?\n"
    "  plsc develop examples/gecko.pls    which robot grows from it?\n"
    "  plsc simulate examples/gecko.pls   how does it walk?\n"
    "  plsc random --seed 1 | plsc develop - --env inclined=True\n"
    "  plsc evolve examples/small.yaml -o run1.sqlite\n\n"
    "`plsc COMMAND --help` explains one command. Exit status: 0 fine, 1 the "
    "input is\nwrong, 2 the usage is wrong.";

// The command that the user typed, or the whole program.
const CLI::App& Chosen(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? app : Chosen(*chosen.front());
}

/// "plsc study run"
std::string FullName(const CLI::App& app) {
  const CLI::App* parent = app.get_parent();
  return (parent == nullptr ? "" : FullName(*parent) + " ") + app.get_name();
}

std::string DidYouMean(const std::string& word,
                       const std::vector<std::string>& names) {
  const std::vector<std::string_view> known(names.begin(), names.end());
  const auto nearest = Suggest(word, known);
  return nearest ? "; did you mean '" + *nearest + "'?" : "";
}

std::vector<std::string> CommandNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({}))
    names.push_back(command->get_name());
  return names;
}

std::vector<std::string> OptionNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames())
      names.push_back("--" + name);
  return names;
}

// CLI11 lists what it did not expect from the back, options and values mixed.
std::string ExplainExtras(const CLI::App& app) {
  const CLI::App& chosen = Chosen(app);
  std::vector<std::string> extras = app.remaining(true);
  const auto option =
      std::find_if(extras.begin(), extras.end(),
                   [](const std::string& s) { return s.starts_with('-'); });
  const std::string& word = option == extras.end() ? extras.front() : *option;
  if (option == extras.end()) return "unexpected argument '" + word + "'";
  return "unknown option '" + word + "'" +
         DidYouMean(word, OptionNames(chosen));
}

Answer UsageError(const CLI::App& app, const std::string& message) {
  return {
      Exit::kBadUsage, "",
      "plsc: " + message + "\nsee '" + FullName(Chosen(app)) + " --help'\n"};
}

// Of a word that is none of an option's, CLI11 says "--format: Check foo value
// in {json->...", with the values behind the words, which are bytes here.
std::string ExplainChoice(const CLI::App& app, const std::string& message) {
  const std::size_t check = message.find(": Check ");
  const std::size_t value = message.rfind(" value in {");
  if (check == std::string::npos || value == std::string::npos) return message;
  const std::string name = message.substr(0, check);
  const std::size_t word = check + std::string_view(": Check ").size();
  for (const CLI::Option* option : Chosen(app).get_options()) {
    if (option->get_name() != name) continue;
    std::string type = option->get_type_name();  // "text|json:..."
    type.resize(std::min(type.size(), type.find(':')));
    const std::string found = message.substr(word, value - word);
    std::istringstream words(type);
    std::vector<std::string> known;
    for (std::string one; std::getline(words, one, '|');) known.push_back(one);
    return fmt::format("{}: expected {}, found '{}'{}", name, type, found,
                       DidYouMean(found, known));
  }
  return message;
}

// Help and version are no errors; CLI11 reports both by throwing.
Answer AnswerTo(const CLI::App& app, const CLI::ParseError& error) {
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    return UsageError(app, ExplainExtras(app));
  std::ostringstream out;
  std::ostringstream err;
  if (app.exit(error, out, err) == 0) return {Exit::kFine, out.str(), ""};
  return UsageError(app, ExplainChoice(app, error.what()));
}

/// Of the first words, the one that is no command; CLI11 would only say that a
/// command is required.
std::optional<Answer> UnknownCommand(
    const CLI::App& app, const std::vector<std::string>& arguments) {
  const CLI::App* at = &app;
  for (const std::string& word : arguments) {
    const std::vector<std::string> known = CommandNames(*at);
    if (known.empty() || word.starts_with('-')) return std::nullopt;
    if (std::find(known.begin(), known.end(), word) == known.end())
      return UsageError(
          *at, "unknown command '" + word + "'" + DidYouMean(word, known));
    at = at->get_subcommand(word);
  }
  return std::nullopt;
}

// As CLI11 wants them: from the back. It would take "-:12:5", a place in
// standard input, for an option; no option begins like that, so it is given
// the name that diagnostics have for standard input.
std::vector<std::string> ForParsing(const std::vector<std::string>& arguments) {
  std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
  for (std::string& argument : reversed)
    if (argument.starts_with("-:")) argument.replace(0, 1, "<stdin>");
  return reversed;
}

// Whether a word behind an option's value is nothing else that is known: no
// option, no file, no robot of a run.
bool MayBeValue(const std::string& word) {
  std::error_code ignored;
  const bool is_robot =
      word == "best" || word.find_first_not_of("0123456789") == word.npos;
  return !word.starts_with('-') && !is_robot &&
         !std::filesystem::exists(SplitGenotypePath(word).file, ignored);
}

// An option of several values takes one each time it is written: more would
// swallow the positionals behind it.
void TakeOneValueEach(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    const bool is_list =
        option->get_items_expected_max() > 1 || option->get_allow_extra_args();
    if (!is_list || option->get_positional()) continue;
    option->expected(1)->allow_extra_args(false)->multi_option_policy(
        CLI::MultiOptionPolicy::TakeAll);
  }
  for (CLI::App* command : app.get_subcommands({})) TakeOneValueEach(*command);
}

std::vector<Declared> DeclareAll(CLI::App& app, const Registry& registry) {
  app.name("plsc");
  app.description(kOverview);
  app.set_version_flag("--version", std::string("plsc ") + kVersion);
  app.footer(kFooter);
  app.require_subcommand(1);
  std::vector<Declared> all;
  for (const Declare declare : registry) all.push_back(declare(app));
  TakeOneValueEach(app);
  return all;
}

}  // namespace

CommandDescription DescribeCommandLine(const Registry& registry) {
  CLI::App app;
  DeclareAll(app, registry);
  return DescribeApp(app, "");
}

std::string AdviceOnValues(const std::vector<std::string>& arguments,
                           const Registry& registry) {
  CLI::App app;
  DeclareAll(app, registry);
  const CLI::App* chosen = &app;
  for (const std::string& word : arguments) {
    const std::vector<std::string> known = CommandNames(*chosen);
    if (std::find(known.begin(), known.end(), word) == known.end()) break;
    chosen = chosen->get_subcommand(word);
  }
  for (std::size_t i = 0; i + 2 < arguments.size(); ++i) {
    const CLI::Option* option = chosen->get_option_no_throw(arguments[i]);
    const std::string& value = arguments[i + 1];
    const std::string& word = arguments[i + 2];
    if (option == nullptr || option->get_items_expected_max() == 0 ||
        option->get_multi_option_policy() != CLI::MultiOptionPolicy::TakeAll ||
        !MayBeValue(word))
      continue;
    return fmt::format(
        "= help: {0} takes one value each time: {0} {1} {0} {2}\n",
        arguments[i], value, word);
  }
  return "";
}

Command ParseArguments(const std::vector<std::string>& arguments,
                       const Registry& registry) {
  CLI::App app;
  const std::vector<Declared> all = DeclareAll(app, registry);
  if (auto answer = UnknownCommand(app, arguments))
    return Command(std::make_unique<Answer>(*answer));
  try {
    app.parse(ForParsing(arguments));
  } catch (const CLI::ParseError& error) {
    return Command(std::make_unique<Answer>(AnswerTo(app, error)));
  }
  const auto chosen =
      std::find_if(all.begin(), all.end(),
                   [](const Declared& one) { return one.app->parsed(); });
  assert(chosen != all.end());
  return chosen->command;
}

Exit Run(const Answer& answer, Io& io) {
  io.out << answer.out;
  io.err << answer.err;
  return answer.exit;
}

}  // namespace plsc::cli
