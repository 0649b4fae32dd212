// Options and help of the commands that make runs of evolution, and look at
// them.

#include <CLI/CLI.hpp>

#include "runtime/cli/arguments/add_commands.h"

namespace plsc::cli {

namespace {

void AddResuming(CLI::App* sub, EvolveCommand& command) {
  sub->add_option("--resume", command.resume,
                  "go on with a run that was stopped or killed, whenever that "
                  "was; the results are those of a run never interrupted")
      ->option_text("RUN");
  sub->add_flag("--or-resume", command.or_resume,
                "if the output exists already, go on with it (it must be of "
                "the same experiment and seed)");
  sub->add_option("--salvage", command.salvage,
                  "make a damaged run again, as --output, with all of its "
                  "simulations that are whole; EXPERIMENT is needed only if "
                  "what the run is was damaged, too")
      ->option_text("RUN");
  sub->add_flag(
      "--allow-other-version", command.allow_other_version,
      "go on with a run that another version of plsc, or another kind "
      "of machine, began");
}

void AddWorkers(CLI::App* sub, EvolveCommand& command) {
  sub->add_option("--jobs", command.jobs,
                  "worker processes (0 and default: one a core that may be "
                  "used; under mpirun of each rank, default one); changes no "
                  "result")
      ->check(CLI::Range(0, 1024))
      ->option_text("N");
  sub->add_option("--hang-limit", command.hang_limit,
                  "seconds without an answer after which a worker is replaced "
                  "(default: 300 and 20 times what the largest robot takes; "
                  "0: never)")
      ->check(CLI::NonNegativeNumber)
      ->option_text("SECONDS");
  sub->add_option("--cache", command.cache,
                  "look simulations up in this file first and add new ones to "
                  "it; runs can share it. Changes no result")
      ->option_text("FILE");
}

}  // namespace

CLI::App* AddEvolve(CLI::App& app, EvolveCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "evolve", "Evolve robots as an experiment file describes");
  sub->add_option("EXPERIMENT", command.experiment,
                  "YAML file; every key has the paper's value as default");
  sub->add_option("-o,--output", command.output,
                  "the run's store, an SQLite file to make; must not exist")
      ->option_text("RUN");
  sub->add_option("--seed", command.seed, "instead of the experiment's seed")
      ->check(CLI::NonNegativeNumber)
      ->option_text("N");
  AddResuming(sub, command);
  AddWorkers(sub, command);
  sub->add_flag("--quiet", command.quiet, "no progress line");
  sub->add_option("--json-log", command.json_log,
                  "also write progress as JSON, an object a line; - is "
                  "standard output")
      ->option_text("FILE");
  AddFormat(sub, command.format, "the best robot and the figures of the run");
  sub->footer(
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
  return sub;
}

CLI::App* AddShow(CLI::App& app, ShowCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "show", "Show a run of evolution, or one of its robots");
  sub->add_option("RUN", command.run, "the store that plsc evolve made")
      ->required();
  sub->add_option("ID", command.individual,
                  "number of a robot, or best: the best of the last generation "
                  "(default: how far the run is)");
  sub->add_option("--lineage", command.lineage,
                  "generations of ancestors to list (default 3)")
      ->check(CLI::Range(0, 1000))
      ->option_text("N");
  sub->add_flag("--genotype", command.genotype,
                "print its genotype and nothing else");
  sub->add_flag("--verify", command.verify,
                "compare all of the run with its checksums first (about a "
                "second for 10,000 robots); robots that are shown always are");
  AddFormat(sub, command.format, "one object");
  sub->footer(
      "Works while the run goes on.\n\n"
      "  plsc show run1.sqlite\n"
      "  plsc show run1.sqlite 17 --lineage 10\n"
      "  plsc show run1.sqlite best --genotype > best.pls\n"
      "  plsc show run1.sqlite best --format json | jq .seasons[0].fitness");
  return sub;
}

CLI::App* AddReplay(CLI::App& app, ReplayCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "replay", "Simulate robots of a run again, and compare every number");
  sub->add_option("RUN", command.run, "the store that plsc evolve made")
      ->required();
  sub->add_option("ID", command.individuals,
                  "numbers of robots, or best (default: best)");
  sub->add_flag("--all", command.all, "every robot that was evaluated");
  sub->add_option("--jobs", command.jobs,
                  "worker processes (0 and default: one a core that may be "
                  "used)")
      ->check(CLI::Range(0, 1024))
      ->option_text("N");
  AddFormat(sub, command.format, "one object a robot");
  sub->footer(
      "Robots develop from the stored genotype and live the stored scenario; "
      "nothing is\nlooked up. Every stored number must come out again, bit for "
      "bit. It does on\nmachines of the kind that made the run, with the same "
      "version of plsc.\n\n"
      "  plsc replay run1.sqlite best\n"
      "  plsc replay run1.sqlite 3 17 120\n"
      "  plsc replay run1.sqlite --all\n\n"
      "Exit status: 0 all equal, 1 something differs or cannot be read.");
  return sub;
}

}  // namespace plsc::cli
