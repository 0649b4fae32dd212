// The command line as a whole, and what is said of a wrong one. The
// arguments_*.cc files are the only ones that know CLI11.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "grammar/suggest.h"
#include "runtime/cli/arguments_commands.h"
#include "runtime/cli/commands.h"
#include "runtime/cli/version.h"

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
    "  plsc evolve examples/small.yaml -o run1\n\n"
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

// Help and version are no errors; CLI11 reports both by throwing.
Answer AnswerTo(const CLI::App& app, const CLI::ParseError& error) {
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    return UsageError(app, ExplainExtras(app));
  std::ostringstream out;
  std::ostringstream err;
  if (app.exit(error, out, err) == 0) return {Exit::kFine, out.str(), ""};
  return UsageError(app, error.what());
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

}  // namespace

void AddFormat(CLI::App* command, OutputFormat& format, const char* json) {
  command
      ->add_option("--format", format,
                   std::string("text for people (default), or json: ") + json)
      ->transform(CLI::CheckedTransformer(std::map<std::string, OutputFormat>{
          {"text", OutputFormat::kText}, {"json", OutputFormat::kJson}}))
      ->type_name("text|json")
      ->option_text("text|json");
}

Command ParseArguments(const std::vector<std::string>& arguments) {
  CLI::App app(kOverview, "plsc");
  app.set_version_flag("--version", std::string("plsc ") + kVersion);
  app.footer(kFooter);
  app.require_subcommand(1);

  CheckCommand check;
  ExplainCommand explain;
  ExportCommand export_command;
  FixCommand fix;
  FmtCommand fmt;
  DevelopCommand develop;
  LintCommand lint;
  RegulateCommand regulate;
  SimulateCommand simulate;
  EvolveCommand evolve;
  ReplayCommand replay;
  ShowCommand show;
  RandomCommand random;
  StudyListCommand study_list;
  StudyRunCommand study_run;
  StudyStatusCommand study_status;
  WhyCommand why;
  TestCommand test;
  const CLI::App* check_app = AddCheck(app, check);
  const CLI::App* explain_app = AddExplain(app, explain);
  const CLI::App* export_app = AddExport(app, export_command);
  const CLI::App* fix_app = AddFix(app, fix);
  const CLI::App* fmt_app = AddFmt(app, fmt);
  const CLI::App* develop_app = AddDevelop(app, develop);
  const CLI::App* lint_app = AddLint(app, lint);
  const CLI::App* regulate_app = AddRegulate(app, regulate);
  const CLI::App* simulate_app = AddSimulate(app, simulate);
  const CLI::App* evolve_app = AddEvolve(app, evolve);
  const CLI::App* show_app = AddShow(app, show);
  const CLI::App* replay_app = AddReplay(app, replay);
  const StudyApps study_apps =
      AddStudy(app, study_list, study_run, study_status);
  const CLI::App* why_app = AddWhy(app, why);
  const CLI::App* test_app = AddTest(app, test);

  AddRandom(app, random);

  if (auto answer = UnknownCommand(app, arguments)) return *answer;
  try {
    app.parse(ForParsing(arguments));
  } catch (const CLI::ParseError& error) {
    return AnswerTo(app, error);
  }
  if (check_app->parsed()) return check;
  if (explain_app->parsed()) return explain;
  if (export_app->parsed()) return export_command;
  if (fix_app->parsed()) return fix;
  if (fmt_app->parsed()) return fmt;
  if (develop_app->parsed()) return develop;
  if (lint_app->parsed()) return lint;
  if (regulate_app->parsed()) return regulate;
  if (simulate_app->parsed()) return simulate;
  if (evolve_app->parsed()) return evolve;
  if (show_app->parsed()) return show;
  if (replay_app->parsed()) return replay;
  if (study_apps.list->parsed()) return study_list;
  if (study_apps.run->parsed()) return study_run;
  if (study_apps.status->parsed()) return study_status;
  if (why_app->parsed()) return why;
  if (test_app->parsed()) return test;
  return random;
}

}  // namespace plsc::cli
