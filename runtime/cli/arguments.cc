// The command line's grammar and its help texts. The only file that knows
// CLI11.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "grammar/suggest.h"
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

void AddFormat(CLI::App* command, OutputFormat& format, const char* json) {
  command
      ->add_option("--format", format,
                   std::string("text for people (default), or json: ") + json)
      ->transform(CLI::CheckedTransformer(std::map<std::string, OutputFormat>{
          {"text", OutputFormat::kText}, {"json", OutputFormat::kJson}}))
      ->type_name("text|json")
      ->option_text("text|json");
}

void AddEnvironments(CLI::App* command,
                     std::vector<std::string>& environments) {
  command
      ->add_option("--env", environments,
                   "what the robot senses: STATE=VALUE,... or the name of an "
                   "environment of the file; may be repeated (default: every "
                   "environment that the file names)")
      ->option_text("ENVIRONMENT")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

CLI::App* AddCheck(CLI::App& app, CheckCommand& command) {
  CLI::App* sub =
      app.add_subcommand("check", "Say whether files are correct genotypes");
  sub->add_option("FILE", command.files, "genotype files; - is standard input")
      ->required();
  sub->add_option("--format", command.format,
                  "text for people (default); json: one diagnostic a line; "
                  "sarif: one SARIF 2.1.0 document; github: annotations of "
                  "GitHub Actions")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, CheckFormat>{{"text", CheckFormat::kText},
                                             {"json", CheckFormat::kJson},
                                             {"sarif", CheckFormat::kSarif},
                                             {"github", CheckFormat::kGithub}}))
      ->type_name("text|json|sarif|github")
      ->option_text("text|json|sarif|github");
  sub->add_flag("--allow-range", command.allow_range,
                "arguments outside their range are warnings, not errors");
  sub->add_option("--color", command.color,
                  "auto (default): on a terminal, unless NO_COLOR is set")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, ColorChoice>{{"auto", ColorChoice::kAuto},
                                             {"always", ColorChoice::kAlways},
                                             {"never", ColorChoice::kNever}}))
      ->type_name("auto|always|never")
      ->option_text("auto|always|never");
  sub->add_option("--max-errors", command.max_errors,
                  "most diagnostics that text shows of a file (default 20); 0 "
                  "shows all")
      ->check(CLI::Range(0, 1000000))
      ->option_text("N");
  sub->add_flag("--lint", command.lint,
                "also show the warnings of 'plsc lint'; they change no exit "
                "status");
  sub->footer(
      "Prints every error that can be found, with file:line:column, the line, "
      "a caret\nand what was expected. Exit status 1 if there is any.\n\n"
      "  plsc check robots/*.pls\n"
      "  plsc check --format json robot.pls | jq .message\n"
      "  plsc check --format github robots/*.pls    in a workflow\n\n"
      "'plsc explain CODE' says more of a code; 'plsc fix' mends what it can.");
  return sub;
}

CLI::App* AddExplain(CLI::App& app, ExplainCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "explain", "Explain a diagnostic's code, with an example mended");
  sub->add_option("CODE", command.code, "as in error[P2001]");
  sub->add_flag("--list", command.list, "all codes, one a line");
  AddFormat(sub, command.format, "one object a code");
  sub->footer(
      "  plsc explain P2001\n"
      "  plsc explain --list");
  return sub;
}

CLI::App* AddFix(CLI::App& app, FixCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "fix", "Mend errors whose mending the diagnostics know");
  sub->add_option("FILE", command.files,
                  "genotype files, rewritten in place; - is standard input, "
                  "printed")
      ->required();
  sub->add_flag("--check", command.check,
                "write nothing; exit status 1 if anything would be mended");
  sub->add_flag("--allow-range", command.allow_range,
                "arguments outside their range are warnings, not errors");
  sub->footer(
      "Makes the replacements that 'plsc check' proposes (\"did you mean\", "
      "\"write\",\n\"insert\"), compiles again, and goes on until nothing more "
      "can be mended. Says\nwhat it changed and what is left. A file is "
      "replaced as a whole or not at all,\nand never by one with more errors. "
      "Exit status 1 if errors remain.\n\n"
      "  plsc fix robot.pls\n"
      "  plsc fix --check robots/*.pls\n"
      "  plsc fix - < robot.pls > mended.pls");
  return sub;
}

CLI::App* AddFmt(CLI::App& app, FmtCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "fmt", "Rewrite files in the canonical layout, comments kept");
  sub->add_option("FILE", command.files,
                  "genotype files, rewritten in place; - is standard input, "
                  "printed")
      ->required();
  sub->add_flag("--check", command.check,
                "write nothing; exit status 1 names files that would change");
  sub->add_flag("--diff", command.diff,
                "write nothing; print what would change as a unified diff; "
                "exit status 1 if anything would")
      ->excludes("--check");
  sub->add_flag("--stdout", command.to_stdout,
                "print the result instead of writing the file");
  sub->add_flag("--compact", command.compact,
                "a group of symbols a line instead of one symbol a line");
  sub->footer(
      "The canonical layout has one symbol a line, so that git merges two "
      "independent\nmutations without conflict. A file is replaced as a whole "
      "or not at all, and only\nwhen the new text means the same genotype.");
  return sub;
}

CLI::App* AddDevelop(CLI::App& app, DevelopCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "develop", "Grow the robot of a genotype in one or more environments");
  sub->add_option("FILE", command.file, "a genotype file; - is standard input")
      ->required();
  AddEnvironments(sub, command.environments);
  AddFormat(sub, command.format, "one robot a line");
  sub->add_option("--svg", command.svg_folder,
                  "also draw each body as FOLDER/GENOTYPE-ENVIRONMENT.svg")
      ->option_text("FOLDER");
  sub->add_flag("--trace", command.trace,
                "also say which rules are active, each rewriting, and what "
                "each symbol did or why it was not expressed");
  sub->add_flag("--allow-range", command.allow_range,
                "arguments outside their range are warnings, not errors");
  sub->footer(
      "The drawing shows the body from above, the core's front up: C core, B "
      "brick,\nA1 vertical joint, A2 horizontal joint, T a touch sensor on a "
      "side; the dot is\nwhere a module hangs on its parent. Genotypes of "
      "other alphabets print their\nstring after each rewriting. --trace "
      "tells the whole story; `plsc why` asks about\none part of it.\n\n"
      "  plsc develop robot.pls --env inclined=True,hot=False\n"
      "  plsc develop robot.pls --env flat --env tilted --svg pictures\n"
      "  plsc develop robot.pls --env flat --format json | jq .body\n"
      "  plsc develop robot.pls --env flat --trace");
  return sub;
}

CLI::App* AddLint(CLI::App& app, LintCommand& command) {
  CLI::App* sub =
      app.add_subcommand("lint", "Warn of what is right but may not be meant");
  sub->add_option("FILE", command.files, "genotype files; - is standard input")
      ->required();
  AddFormat(sub, command.format, "one diagnostic a line");
  sub->add_flag("--deny", command.deny, "exit status 1 if there is a warning");
  sub->add_flag("--allow-range", command.allow_range,
                "arguments outside their range are warnings, not errors");
  sub->footer(
      "Looks at every environment that the clauses can tell apart, and "
      "develops there:\nclauses that are always true or never (W3002), "
      "environments in which no rule of a\nsymbol is active (W3003) or several "
      "at once (W3004), strings that would grow too\nlong (W4001), symbols and "
      "rules that never do anything (W4002). A comment\n'# plsc: allow W3003' "
      "before an item or behind it silences a warning there,\n'# plsc: "
      "allow-file W3003' in the whole file. Exit status 0 with warnings, 1 "
      "with\nerrors or, with --deny, with any warning.\n\n"
      "  plsc lint robots/*.pls\n"
      "  plsc lint --deny --format json robot.pls | jq .message");
  return sub;
}

CLI::App* AddRegulate(CLI::App& app, RegulateCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "regulate", "Show which rules are active where, and what they make");
  sub->add_option("FILE", command.file, "a genotype file; - is standard input")
      ->required();
  CLI::Option* env =
      sub->add_option("--env", command.environments,
                      "STATE=VALUE,... or the name of an environment of the "
                      "file; may be repeated (default: every environment that "
                      "the file names)")
          ->option_text("ENVIRONMENT")
          ->expected(1)
          ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  sub->add_flag("--table", command.table,
                "the truth table of all environments that clauses can tell "
                "apart, a row each")
      ->excludes(env);
  AddFormat(sub, command.format, "one environment a line");
  sub->add_flag("--allow-range", command.allow_range,
                "arguments outside their range are warnings, not errors");
  sub->footer(
      "Rules are numbered from 1, by symbol in the order of the alphabet, then "
      "as in the\nfile. In place of rules, - is a gap (the symbol stays as it "
      "is) and 1+2 means that\nboth productions are joined. In tables a|b are "
      "values that no clause tells apart,\n5..<9 the numbers from 5 to below "
      "9.\n\n"
      "  plsc regulate robot.pls --env inclined=True,hot=False\n"
      "  plsc regulate robot.pls --table");
  return sub;
}

CLI::App* AddSimulate(CLI::App& app, SimulateCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "simulate", "Live the seasons of a scenario in the physics simulator");
  sub->add_option("FILE", command.file, "a genotype file; - is standard input")
      ->required();
  sub->add_option("--scenario", command.scenario,
                  "YAML file with the seasons and the physics (default: the "
                  "paper's, 50 s Flat then 50 s Tilted by 5 degrees)")
      ->option_text("FILE");
  AddFormat(sub, command.format, "one season a line, with all descriptors");
  sub->add_flag("--descriptors", command.descriptors,
                "also list every descriptor, a column a season (json always "
                "has them)");
  sub->add_option("--trajectory", command.trajectory_folder,
                  "also write each season's samples as FOLDER/SEASON.csv")
      ->option_text("FOLDER");
  sub->footer(
      "In every season the robot develops for what it senses there, starts "
      "afresh at the\norigin and is measured: Speed in cm/s uphill (the "
      "robot's front), Balance 0 to 1,\nfitness in m/s as the paper defines "
      "it.\n\n"
      "  plsc simulate examples/gecko.pls\n"
      "  plsc simulate robot.pls --scenario hot.yaml --format json");
  return sub;
}

CLI::App* AddEvolve(CLI::App& app, EvolveCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "evolve", "Evolve robots as an experiment file describes");
  sub->add_option("EXPERIMENT", command.experiment,
                  "YAML file; every key has the paper's value as default")
      ->required();
  sub->add_option("-o,--output", command.output,
                  "folder to make for the results; must not exist")
      ->required()
      ->option_text("FOLDER");
  sub->add_option("--seed", command.seed, "instead of the experiment's seed")
      ->check(CLI::NonNegativeNumber)
      ->option_text("N");
  sub->add_option("--jobs", command.jobs,
                  "worker processes (default: one a core); changes no result")
      ->check(CLI::Range(1, 1024))
      ->option_text("N");
  sub->add_flag("--quiet", command.quiet, "no progress line");
  AddFormat(sub, command.format, "the best robot and the figures of the run");
  sub->footer(
      "Prints a progress line and, at the end, the best robot's genotype and "
      "bodies.\nThe same experiment and seed give the same results, bit for "
      "bit, whatever the\nnumber of workers. Ctrl-C stops cleanly.\n\n"
      "  plsc evolve examples/small.yaml -o run1 --seed 7");
  return sub;
}

CLI::App* AddRandom(CLI::App& app, RandomCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "random", "Write a random genotype, as evolution begins with");
  sub->add_option("--seed", command.seed,
                  "the same seed gives the same genotype")
      ->required()
      ->check(CLI::NonNegativeNumber)
      ->option_text("N");
  sub->add_option("--encoding", command.encoding,
                  "plasticoding (default): rules with clauses; baseline: one "
                  "rule a symbol, always active")
      ->check(CLI::IsMember({"plasticoding", "baseline"}))
      ->option_text("ENCODING");
  sub->add_option("--states", command.states,
                  "states that clauses ask about (default: inclined)")
      ->delimiter(',')
      ->option_text("NAME,...");
  sub->add_option("--max-groups", command.max_groups,
                  "most groups of five symbols a rule (default 4)")
      ->check(CLI::Range(1, 100))
      ->option_text("N");
  sub->add_option("--max-rules", command.max_rules,
                  "rules a symbol, plasticoding only (default 2)")
      ->check(CLI::Range(1, 100))
      ->option_text("N");
  sub->add_option("--max-terms", command.max_terms,
                  "most terms a clause, plasticoding only (default 2)")
      ->check(CLI::Range(1, 100))
      ->option_text("N");
  sub->add_option("-o,--output", command.output,
                  "file to write (default: standard output); must not exist")
      ->option_text("FILE");
  sub->footer(
      "  plsc random --seed 7 -o robot7.pls\n"
      "  plsc random --seed 7 --states inclined,hot");
  return sub;
}

CLI::App* AddWhy(CLI::App& app, WhyCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "why",
      "Explain where a part of a robot comes from, or what became of a "
      "symbol");
  sub->add_option("FILE", command.file,
                  "a genotype file (- is standard input); FILE:LINE:COLUMN "
                  "asks about the symbol there (<stdin>:LINE:COLUMN)")
      ->required();
  CLI::Option* module =
      sub->add_option("--module", command.module,
                      "ask about a module by its number, as 7, or a sensor, "
                      "as 7s1")
          ->option_text("ID");
  CLI::Option* node =
      sub->add_option("--node", command.node, "ask about a neuron or an input")
          ->option_text("nodeN")
          ->excludes(module);
  sub->add_option("--edge", command.edge, "ask about an edge, the source first")
      ->option_text("nodeN-nodeM")
      ->excludes(module)
      ->excludes(node);
  AddEnvironments(sub, command.environments);
  AddFormat(sub, command.format, "one environment a line");
  sub->add_flag("--allow-range", command.allow_range,
                "arguments outside their range are warnings, not errors");
  sub->footer(
      "Back from a part: the symbol that made it and those that changed it, "
      "each with\nits place in the file, the rule and the iteration that "
      "inserted it and what it was\ninserted for, up to the axiom. Forward "
      "from a symbol: every occurrence of it in\nthe string and what that did. "
      "Ids are those of `plsc develop`; exit status 1 when\nno environment has "
      "such a part.\n\n"
      "  plsc why robot.pls --module 7 --env tilted\n"
      "  plsc why robot.pls --edge node3-node1\n"
      "  plsc why robot.pls:12:5 --format json");
  return sub;
}

CLI::App* AddTest(CLI::App& app, TestCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "test", "Compare robots with what their golden files expect");
  sub->add_option("PATH", command.paths,
                  "genotype files, golden files, or folders of them")
      ->required();
  sub->add_flag("--update", command.update,
                "record what was found as expected, where that differs");
  sub->add_option("--jobs", command.jobs,
                  "threads (default: one a core); changes no result")
      ->check(CLI::Range(1, 1024))
      ->option_text("N");
  sub->add_option("--format", command.format,
                  "text for people (default); json: a test a line; junit: XML "
                  "for CI")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, TestFormat>{{"text", TestFormat::kText},
                                            {"json", TestFormat::kJson},
                                            {"junit", TestFormat::kJunit}}))
      ->type_name("text|json|junit")
      ->option_text("text|json|junit");
  sub->add_option("-o,--output", command.output,
                  "write the report there, and text to standard output")
      ->option_text("FILE");
  sub->footer(
      "Develops every genotype robot.pls in the environments that "
      "robot.golden.json\nbeside it names, and shows modules, nodes, edges, "
      "symbols and descriptors that\nare not as recorded. --update makes or "
      "rewrites golden files; git shows what\nchanged. Exit status 1 if a "
      "robot differs or has no golden file.\n\n"
      "  plsc test robots/ --update\n"
      "  plsc test robots/\n"
      "  plsc test robots/ --format junit --output report.xml");
  return sub;
}

// The command that the user typed, or the whole program.
const CLI::App& Chosen(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? app : *chosen.front();
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
  std::string name = "plsc";
  if (&Chosen(app) != &app) name += " " + Chosen(app).get_name();
  return {Exit::kBadUsage, "",
          "plsc: " + message + "\nsee '" + name + " --help'\n"};
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

}  // namespace

Command ParseArguments(const std::vector<std::string>& arguments) {
  CLI::App app(kOverview, "plsc");
  app.set_version_flag("--version", std::string("plsc ") + kVersion);
  app.footer(kFooter);
  app.require_subcommand(1);

  CheckCommand check;
  ExplainCommand explain;
  FixCommand fix;
  FmtCommand fmt;
  DevelopCommand develop;
  LintCommand lint;
  RegulateCommand regulate;
  SimulateCommand simulate;
  EvolveCommand evolve;
  RandomCommand random;
  WhyCommand why;
  TestCommand test;
  const CLI::App* check_app = AddCheck(app, check);
  const CLI::App* explain_app = AddExplain(app, explain);
  const CLI::App* fix_app = AddFix(app, fix);
  const CLI::App* fmt_app = AddFmt(app, fmt);
  const CLI::App* develop_app = AddDevelop(app, develop);
  const CLI::App* lint_app = AddLint(app, lint);
  const CLI::App* regulate_app = AddRegulate(app, regulate);
  const CLI::App* simulate_app = AddSimulate(app, simulate);
  const CLI::App* evolve_app = AddEvolve(app, evolve);
  const CLI::App* why_app = AddWhy(app, why);
  const CLI::App* test_app = AddTest(app, test);

  AddRandom(app, random);

  // CLI11 would only say that a subcommand is required.
  if (!arguments.empty() && !arguments[0].starts_with('-')) {
    const std::vector<std::string> known = CommandNames(app);
    if (std::find(known.begin(), known.end(), arguments[0]) == known.end())
      return UsageError(app, "unknown command '" + arguments[0] + "'" +
                                 DidYouMean(arguments[0], known));
  }
  try {
    // CLI11 takes the arguments from the back.
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ParseError& error) {
    return AnswerTo(app, error);
  }
  if (check_app->parsed()) return check;
  if (explain_app->parsed()) return explain;
  if (fix_app->parsed()) return fix;
  if (fmt_app->parsed()) return fmt;
  if (develop_app->parsed()) return develop;
  if (lint_app->parsed()) return lint;
  if (regulate_app->parsed()) return regulate;
  if (simulate_app->parsed()) return simulate;
  if (evolve_app->parsed()) return evolve;
  if (why_app->parsed()) return why;
  if (test_app->parsed()) return test;
  return random;
}

}  // namespace plsc::cli
