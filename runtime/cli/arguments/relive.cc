#include "runtime/cli/arguments/relive.h"

#include "runtime/cli/arguments/common_options.h"
#include "runtime/cli/arguments/options.h"

namespace plsc::cli {

void Add(Options& options, ReliveCommand& command) {
  options.Command("relive",
                  "Let robots of runs live again, to see what their records "
                  "are worth");
  options
      .Add("STUDY|RUN", command.paths,
           "folders of studies, of one experiment of a study, or of runs; runs")
      .ValueName("STUDY|RUN...")
      .Required();
  options
      .Add("--generations", command.generations,
           "whose survivors live again: last (default: the last completed "
           "one), all, 'every N' (and the last), or numbers from 0 with commas "
           "between them")
      .ValueName("last|all|N,...");
  options.Add("--lives", command.lives, "lives of each robot (default 20)")
      .Range(1, 100000)
      .ValueName("N");
  options
      .Add("--swap", command.swaps,
           "lives of each robot that differs between seasons with another "
           "season's body and brain, in each season (default 5, at most as "
           "many as --lives; 0: none)")
      .Range(0, 100000)
      .ValueName("N");
  options.Flag("--engine-check", command.engine_check,
               "the best robot of each generation also lives by the engine "
               "that the run did not have (seconds a life if that is ODE)");
  AddJobs(options, command.jobs,
          "worker processes (0 and default: one a core that may be used); "
          "changes no result");
  options.Flag("--quiet", command.quiet, "no progress");
  AddFormat(options, command.format, "one object of all runs, in SI units");
  options.Footer(
      "A life is one draw from what a robot does: its gait is chaotic, and "
      "selection\nkeeps draws that were lucky. So records of a run are too "
      "high, and not by the same\nin every run. Here each survivor lives again "
      "N times as it lived, but that its start\nis higher by 0 to 30 "
      "micrometres, at random. Its median is what it does; what the\nrecord is "
      "above that was luck.\n\n"
      "  recorded   Speed in the run: of the best robot, and the mean of all\n"
      "  relived    the median of its lives, and the mean of all medians\n"
      "  quartiles  of the best robot's lives; of the robots' medians\n"
      "  swapped    Speed of robots that differ between seasons, with the "
      "body and brain\n"
      "             of another season: what they lose is what the difference "
      "is good for\n\n"
      "All lives, with all measures, are kept in RUN.relived.sqlite beside the "
      "run, which\nstays as it is (docs/runs.md). What is there is not lived "
      "again: the same command\nagain shows it, and with more lives or "
      "generations adds what is missing. Ctrl-C, a\nkill or a full disk lose "
      "nothing that was lived. `plsc report` shows relived values\nbefore "
      "recorded ones.\n\n"
      "  plsc relive run1.sqlite\n"
      "  plsc relive paper --lives 10 --jobs 8\n"
      "  plsc relive run1.sqlite --generations 'every 20' --swap 0\n"
      "  plsc relive run1.sqlite --engine-check --format json\n\n"
      "Exit status: 0 all lived, 1 a run or its file cannot be read or "
      "written, 130 stopped\nby Ctrl-C or SIGTERM.");
}

}  // namespace plsc::cli
