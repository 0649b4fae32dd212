#include "runtime/cli/arguments/runs.h"

#include "runtime/cli/arguments/common_options.h"
#include "runtime/cli/arguments/options.h"

namespace plsc::cli {

namespace {

void AddResuming(Options& options, EvolveCommand& command) {
  options
      .Add("--resume", command.resume,
           "go on with a run that was stopped or killed, whenever that "
           "was; the results are those of a run never interrupted")
      .ValueName("RUN");
  options.Flag("--or-resume", command.or_resume,
               "if the output exists already, go on with it (it must be of "
               "the same experiment and seed)");
  options
      .Add("--salvage", command.salvage,
           "make a damaged run again, as --output, with all of its "
           "simulations that are whole; EXPERIMENT is needed only if "
           "what the run is was damaged, too")
      .ValueName("RUN");
  options.Flag("--allow-other-version", command.allow_other_version,
               "go on with a run that another version of plsc, or another kind "
               "of machine, began");
}

void AddWorkers(Options& options, EvolveCommand& command) {
  AddJobs(options, command.jobs,
          "worker processes (0 and default: one a core that may be "
          "used; under mpirun of each rank, default one); changes no "
          "result");
  options
      .Add("--hang-limit", command.hang_limit,
           "seconds without an answer after which a worker is replaced "
           "(default: 300 and 20 times what the largest robot takes; "
           "0: never)")
      .NotNegative()
      .ValueName("SECONDS");
  options
      .Add("--cache", command.cache,
           "look simulations up in this file first and add new ones to "
           "it; runs can share it. Changes no result")
      .ValueName("FILE");
}

}  // namespace

void Add(Options& options, EvolveCommand& command) {
  options.Command("evolve", "Evolve robots as an experiment file describes");
  options.Add("EXPERIMENT", command.experiment,
              "YAML file; every key has the paper's value as default");
  options
      .Add("-o,--output", command.output,
           "the run's store, an SQLite file to make; must not exist")
      .ValueName("RUN");
  options.Add("--seed", command.seed, "instead of the experiment's seed")
      .NotNegative()
      .ValueName("N");
  AddEngine(options, command.engine);
  AddResuming(options, command);
  AddWorkers(options, command);
  options.Flag("--quiet", command.quiet, "no progress line");
  options
      .Add("--json-log", command.json_log,
           "also write progress as JSON, an object a line; - is "
           "standard output")
      .ValueName("FILE");
  AddFormat(options, command.format,
            "the best robot and the figures of the run");
  options.Footer(
      "Prints a progress line and, at the end, the best robot's genotype and "
      "bodies.\nAll results are in RUN (docs/runs.md): look at them with `plsc "
      "show`, `plsc export`\nor any tool that reads SQLite, also while the run "
      "goes on. The same experiment\nand seed give the same results, bit for "
      "bit, whatever the number of workers and\nhowever often the run was "
      "stopped. Ctrl-C stops cleanly.\n\n"
      "  plsc evolve examples/small.yaml -o run1.sqlite --seed 7\n"
      "  plsc evolve --resume run1.sqlite\n"
      "  plsc show run1.sqlite best\n"
      "  mpirun -n 8 plsc evolve examples/small.yaml -o run2.sqlite");
}

void Add(Options& options, ShowCommand& command) {
  options.Command("show", "Show a run of evolution, or one of its robots");
  options.Add("RUN", command.run, "the store that plsc evolve made").Required();
  options.Add("ID", command.individual,
              "number of a robot, or best: the best of the last generation "
              "(default: how far the run is)");
  options
      .Add("--lineage", command.lineage,
           "generations of ancestors to list (default 3)")
      .Range(0, 1000)
      .ValueName("N");
  options.Flag("--genotype", command.genotype,
               "print its genotype and nothing else");
  options.Flag("--verify", command.verify,
               "compare all of the run with its checksums first (about a "
               "second for 10,000 robots); robots that are shown always are");
  AddFormat(options, command.format, "one object");
  options.Footer(
      "Works while the run goes on.\n\n"
      "  plsc show run1.sqlite\n"
      "  plsc show run1.sqlite 17 --lineage 10\n"
      "  plsc show run1.sqlite best --genotype > best.pls\n"
      "  plsc show run1.sqlite best --format json | jq .seasons[0].fitness");
}

void Add(Options& options, ReplayCommand& command) {
  options.Command("replay",
                  "Simulate robots of a run again, and compare every number");
  options.Add("RUN", command.run, "the store that plsc evolve made").Required();
  options.Add("ID", command.individuals,
              "numbers of robots, or best (default: best)");
  options.Flag("--all", command.all, "every robot that was evaluated");
  options.Choice(
      "--engine", command.engine,
      "live them by this engine, and tell how its ranks and Speeds "
      "differ from the stored ones (default then: all survivors of "
      "the last generation)",
      {{"ode", EngineKind::kOde}, {"articulated", EngineKind::kArticulated}});
  AddJobs(options, command.jobs,
          "worker processes (0 and default: one a core that may be "
          "used)");
  AddFormat(options, command.format,
            "one object a robot; with --engine one of all");
  options.Footer(
      "Robots develop from the stored genotype and live the stored scenario; "
      "nothing is\nlooked up. Every stored number must come out again, bit for "
      "bit. It does on\nmachines of the kind that made the run, with the same "
      "version of plsc; what the\narticulated engine lived on every machine.\n"
      "With --engine the bits are others, and what counts is whether robots "
      "keep their\nranks: Spearman's rank correlation of their Speeds, and "
      "differences, a line a season.\n\n"
      "  plsc replay run1.sqlite best\n"
      "  plsc replay run1.sqlite 3 17 120\n"
      "  plsc replay run1.sqlite --all\n"
      "  plsc replay run1.sqlite --engine ode\n\n"
      "Exit status: 0 all equal (with --engine: all lived), 1 something "
      "differs or cannot\nbe read.");
}

}  // namespace plsc::cli
