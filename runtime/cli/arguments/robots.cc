#include "runtime/cli/arguments/robots.h"

#include "runtime/cli/arguments/common_options.h"
#include "runtime/cli/arguments/options.h"

namespace plsc::cli {

namespace {

void AddEnvironments(Options& options, std::vector<std::string>& environments) {
  options
      .Add("--env", environments,
           "what the robot senses: STATE=VALUE,... or the name of an "
           "environment of the file; may be repeated (default: every "
           "environment that the file names)")
      .ValueName("ENVIRONMENT");
}

}  // namespace

void Add(Options& options, DevelopCommand& command) {
  options.Command("develop",
                  "Grow the robot of a genotype in one or more environments");
  options.Add("FILE", command.file, "a genotype file; - is standard input")
      .Required();
  AddEnvironments(options, command.environments);
  AddFormat(options, command.format, "one robot a line");
  options
      .Add("--svg", command.svg_folder,
           "also draw each body as FOLDER/GENOTYPE-ENVIRONMENT.svg")
      .ValueName("FOLDER");
  AddForce(options, command.force);
  options.Flag("--trace", command.trace,
               "also say which rules are active, each rewriting, and what "
               "each symbol did or why it was not expressed");
  AddAllowRange(options, command.allow_range);
  options.Footer(
      "The drawing shows the body from above, the core's front up: C core, B "
      "brick,\nA1 vertical joint, A2 horizontal joint, T a touch sensor on a "
      "side; the dot is\nwhere a module hangs on its parent. Genotypes of "
      "other alphabets print their\nstring after each rewriting. --trace "
      "tells the whole story; `plsc why` asks about\none part of it.\n\n"
      "  plsc develop robot.pls --env inclined=True,hot=False\n"
      "  plsc develop robot.pls --env flat --env tilted --svg pictures\n"
      "  plsc develop robot.pls --env flat --format json | jq .body\n"
      "  plsc develop robot.pls --env flat --trace");
}

void Add(Options& options, RandomCommand& command) {
  options.Command("random", "Write random genotypes, as evolution begins with");
  options
      .Add("--seed", command.seed,
           "the same seed gives the same genotypes (default: the "
           "experiment's)")
      .NotNegative()
      .ValueName("N");
  options
      .Add("--count", command.count,
           "genotypes, in one file (default: 1; with --experiment the "
           "population)")
      .Range(1, 100000)
      .ValueName("N");
  const Option experiment =
      options
          .Add("--experiment", command.experiment,
               "YAML file: the population that a run of that "
               "experiment begins with, bit for bit")
          .ValueName("FILE");
  options
      .Add("--encoding", command.encoding,
           "plasticoding (default): rules with clauses; baseline: one "
           "rule a symbol, always active")
      .OneOf({"plasticoding", "baseline"})
      .ValueName("ENCODING")
      .Excludes(experiment);
  options
      .Add("--states", command.states,
           "states that clauses ask about (default: inclined)")
      .SplitAt(',')
      .ValueName("NAME,...")
      .Excludes(experiment);
  const auto add_limit = [&](const char* name, int& limit, const char* help) {
    options.Add(name, limit, help)
        .Range(1, 100)
        .ValueName("N")
        .Excludes(experiment);
  };
  add_limit("--max-groups", command.max_groups,
            "most groups of five symbols a rule (default 4)");
  add_limit("--max-rules", command.max_rules,
            "rules a symbol, plasticoding only (default 2)");
  add_limit("--max-terms", command.max_terms,
            "most terms a clause, plasticoding only (default 2)");
  AddOutput(options, command.output, command.force);
  options.Footer(
      "One of --seed and --experiment is required. Several genotypes are named "
      "random_7_1,\nrandom_7_2 and so on, those of an experiment as in its "
      "runs; FILE#NAME is one of them.\n\n"
      "  plsc random --seed 7 -o robot7.pls\n"
      "  plsc random --seed 7 --states inclined,hot\n"
      "  plsc random --experiment examples/small.yaml --seed 3 -o first.pls");
}

void Add(Options& options, RegulateCommand& command) {
  options.Command("regulate",
                  "Show which rules are active where, and what they make");
  options.Add("FILE", command.file, "a genotype file; - is standard input")
      .Required();
  const Option env =
      options
          .Add("--env", command.environments,
               "STATE=VALUE,... or the name of an environment of the "
               "file; may be repeated (default: every environment that "
               "the file names)")
          .ValueName("ENVIRONMENT");
  options
      .Flag("--table", command.table,
            "the truth table of all environments that clauses can tell "
            "apart, a row each")
      .Excludes(env);
  AddFormat(options, command.format, "one environment a line");
  AddAllowRange(options, command.allow_range);
  options.Footer(
      "Rules are numbered from 1, by symbol in the order of the alphabet, then "
      "as in the\nfile. In place of rules, - is a gap (the symbol stays as it "
      "is) and 1+2 means that\nboth productions are joined. In tables a|b are "
      "values that no clause tells apart,\n5..<9 the numbers from 5 to below "
      "9.\n\n"
      "  plsc regulate robot.pls --env inclined=True,hot=False\n"
      "  plsc regulate robot.pls --table");
}

void Add(Options& options, SimulateCommand& command) {
  options.Command("simulate",
                  "Live the seasons of a scenario in the physics simulator");
  options
      .Add("FILE", command.file,
           "a genotype file (- is standard input), or the store of a "
           "run")
      .Required();
  AddRobot(options, command.individual);
  options
      .Add("--scenario", command.scenario,
           "YAML file with the seasons and the physics (default: the "
           "run's; of a file the paper's, 50 s Flat then 50 s Tilted by "
           "5 degrees)")
      .ValueName("FILE");
  AddEngine(options, command.engine);
  AddFormat(options, command.format, "one season a line, with all descriptors");
  options.Flag("--descriptors", command.descriptors,
               "also list every descriptor, a column a season (json always "
               "has them)");
  options
      .Add("--trajectory", command.trajectory_folder,
           "also write each season's samples as FOLDER/SEASON.csv, and "
           "FOLDER/scenario.yaml with every constant")
      .ValueName("FOLDER");
  options
      .Add("--record", command.record,
           "also write the pose of every link, 50 times a second, to be "
           "replayed (one JSON file, see docs/formats.md)")
      .ValueName("FILE");
  options
      .Add("--svg", command.svg,
           "also draw the path of each season seen from above, with the "
           "body at the start and at the end")
      .ValueName("FILE");
  AddForce(options, command.force);
  options.Footer(
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
      "  plsc simulate robot.pls --engine articulated\n"
      "  plsc simulate robot.pls --record robot.rec.json --svg robot.svg\n"
      "  plsc simulate run1.sqlite best --descriptors");
}

void Add(Options& options, TestCommand& command) {
  options.Command("test", "Compare robots with what their golden files expect");
  options
      .Add("PATH", command.paths,
           "genotype files, golden files, or folders of them")
      .Required();
  options.Flag("--update", command.update,
               "record what was found as expected, where that differs");
  AddJobs(options, command.jobs,
          "threads (0 and default: one a core that may be used); "
          "changes no result");
  options.Choice("--format", command.format,
                 "text for people (default); json: a test a line; junit: XML "
                 "for CI",
                 {{"text", TestFormat::kText},
                  {"json", TestFormat::kJson},
                  {"junit", TestFormat::kJunit}});
  options
      .Add("-o,--output", command.output,
           "write the report there, and text to standard output")
      .ValueName("FILE");
  AddForce(options, command.force);
  options.Footer(
      "Develops every genotype robot.pls in the environments that "
      "robot.golden.json\nbeside it names, and shows modules, nodes, edges, "
      "symbols and descriptors that\nare not as recorded. --update makes or "
      "rewrites golden files; git shows what\nchanged. Exit status 1 if a "
      "robot differs or has no golden file.\n\n"
      "  plsc test robots/ --update\n"
      "  plsc test robots/\n"
      "  plsc test robots/ --format junit --output report.xml");
}

void Add(Options& options, WhyCommand& command) {
  options.Command(
      "why",
      "Explain where a part of a robot comes from, or what became of a "
      "symbol");
  options
      .Add("FILE", command.file,
           "a genotype file (- is standard input); FILE:LINE:COLUMN "
           "asks about the symbol there, also -:LINE:COLUMN; or the "
           "store of a run")
      .Required();
  AddRobot(options, command.individual);
  const Option module =
      options
          .Add("--module", command.module,
               "ask about a module by its number, as 7, or a sensor, "
               "as 7s1")
          .ValueName("ID");
  const Option node =
      options.Add("--node", command.node, "ask about a neuron or an input")
          .ValueName("nodeN")
          .Excludes(module);
  options.Add("--edge", command.edge, "ask about an edge, the source first")
      .ValueName("nodeN-nodeM")
      .Excludes(module)
      .Excludes(node);
  AddEnvironments(options, command.environments);
  AddFormat(options, command.format, "one environment a line");
  AddAllowRange(options, command.allow_range);
  options.Footer(
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
}

}  // namespace plsc::cli
