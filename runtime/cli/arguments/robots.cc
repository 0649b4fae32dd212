// Options and help of the commands that make robots of genotypes.

#include <CLI/CLI.hpp>

#include "runtime/cli/arguments/add_commands.h"

namespace plsc::cli {

namespace {

void AddEnvironments(CLI::App* command,
                     std::vector<std::string>& environments) {
  command
      ->add_option("--env", environments,
                   "what the robot senses: STATE=VALUE,... or the name of an "
                   "environment of the file; may be repeated (default: every "
                   "environment that the file names)")
      ->option_text("ENVIRONMENT");
}

void AddRobot(CLI::App* command, std::string& individual) {
  command
      ->add_option("ROBOT", individual,
                   "which robot of the run: a number, or best")
      ->option_text("ROBOT");
}

}  // namespace

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
  AddForce(sub, command.force);
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

CLI::App* AddRandom(CLI::App& app, RandomCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "random", "Write random genotypes, as evolution begins with");
  sub->add_option("--seed", command.seed,
                  "the same seed gives the same genotypes (default: the "
                  "experiment's)")
      ->check(CLI::NonNegativeNumber)
      ->option_text("N");
  sub->add_option("--count", command.count,
                  "genotypes, in one file (default: 1; with --experiment the "
                  "population)")
      ->check(CLI::Range(1, 100000))
      ->option_text("N");
  CLI::Option* experiment =
      sub->add_option("--experiment", command.experiment,
                      "YAML file: the population that a run of that "
                      "experiment begins with, bit for bit")
          ->option_text("FILE");
  sub->add_option("--encoding", command.encoding,
                  "plasticoding (default): rules with clauses; baseline: one "
                  "rule a symbol, always active")
      ->check(CLI::IsMember({"plasticoding", "baseline"}))
      ->option_text("ENCODING")
      ->excludes(experiment);
  sub->add_option("--states", command.states,
                  "states that clauses ask about (default: inclined)")
      ->delimiter(',')
      ->option_text("NAME,...")
      ->excludes(experiment);
  const auto add_limit = [&](const char* name, int& limit, const char* help) {
    sub->add_option(name, limit, help)
        ->check(CLI::Range(1, 100))
        ->option_text("N")
        ->excludes(experiment);
  };
  add_limit("--max-groups", command.max_groups,
            "most groups of five symbols a rule (default 4)");
  add_limit("--max-rules", command.max_rules,
            "rules a symbol, plasticoding only (default 2)");
  add_limit("--max-terms", command.max_terms,
            "most terms a clause, plasticoding only (default 2)");
  sub->add_option("-o,--output", command.output,
                  "file to write (default: standard output)")
      ->option_text("FILE");
  AddForce(sub, command.force);
  sub->footer(
      "One of --seed and --experiment is required. Several genotypes are named "
      "random_7_1,\nrandom_7_2 and so on, those of an experiment as in its "
      "runs; FILE#NAME is one of them.\n\n"
      "  plsc random --seed 7 -o robot7.pls\n"
      "  plsc random --seed 7 --states inclined,hot\n"
      "  plsc random --experiment examples/small.yaml --seed 3 -o first.pls");
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
          ->option_text("ENVIRONMENT");
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
  sub->add_option("FILE", command.file,
                  "a genotype file (- is standard input), or the store of a "
                  "run")
      ->required();
  AddRobot(sub, command.individual);
  sub->add_option("--scenario", command.scenario,
                  "YAML file with the seasons and the physics (default: the "
                  "run's; of a file the paper's, 50 s Flat then 50 s Tilted by "
                  "5 degrees)")
      ->option_text("FILE");
  AddFormat(sub, command.format, "one season a line, with all descriptors");
  sub->add_flag("--descriptors", command.descriptors,
                "also list every descriptor, a column a season (json always "
                "has them)");
  sub->add_option("--trajectory", command.trajectory_folder,
                  "also write each season's samples as FOLDER/SEASON.csv, and "
                  "FOLDER/scenario.yaml with every constant")
      ->option_text("FOLDER");
  sub->add_option("--record", command.record,
                  "also write the pose of every link, 50 times a second, to be "
                  "replayed (one JSON file, see docs/formats.md)")
      ->option_text("FILE");
  sub->add_option("--svg", command.svg,
                  "also draw the path of each season seen from above, with the "
                  "body at the start and at the end")
      ->option_text("FILE");
  AddForce(sub, command.force);
  sub->footer(
      "In every season the robot senses, develops for what it senses, lives "
      "and is\nmeasured: Speed in cm/s uphill (the robot's front), Balance 0 "
      "to "
      "1, fitness in m/s\nas the paper defines it. The line below each season "
      "tells when and why the robot\nchanged. Seasons start afresh at the "
      "origin, or are one life (lives: continuous).\n"
      "On a terminal a line shows how far a long life is. Ctrl-C ends it: what "
      "was lived\nis written, and the exit status is 130.\n\n"
      "  plsc simulate examples/gecko.pls\n"
      "  plsc simulate examples/gecko.pls --descriptors\n"
      "  plsc simulate robot.pls --scenario hot.yaml --format json\n"
      "  plsc simulate robot.pls --record robot.rec.json --svg robot.svg\n"
      "  plsc simulate run1.sqlite best --descriptors");
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
                  "threads (0 and default: one a core that may be used); "
                  "changes no result")
      ->check(CLI::Range(0, 1024))
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
  AddForce(sub, command.force);
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

CLI::App* AddWhy(CLI::App& app, WhyCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "why",
      "Explain where a part of a robot comes from, or what became of a "
      "symbol");
  sub->add_option("FILE", command.file,
                  "a genotype file (- is standard input); FILE:LINE:COLUMN "
                  "asks about the symbol there, also -:LINE:COLUMN; or the "
                  "store of a run")
      ->required();
  AddRobot(sub, command.individual);
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
      "  plsc why robot.pls:12:5 --format json\n"
      "  plsc why run1.sqlite best --module 3");
  return sub;
}

}  // namespace plsc::cli
