#include "runtime/cli/arguments/view.h"

#include "runtime/cli/arguments/common_options.h"
#include "runtime/cli/arguments/options.h"

namespace plsc::cli {

namespace {

constexpr const char* kFooter =

    "Writes one HTML file that opens from disk in any browser, without "
    "network: all\nlives side by side on one clock, to play, scrub and turn "
    "by mouse, touch or keys;\nseasons on the time line, what changed "
    "between them, joint angles and touch as\nplots. Robots of runs live the "
    "stored scenario again, as plsc replay does; it warns\nwhere that comes "
    "out otherwise.\n\n"
    "  plsc view examples/gecko.pls -o gecko.html\n"
    "  plsc view gecko.rec.json snake.rec.json -o both.html\n"
    "  plsc view examples/gecko.pls --scenario examples/life.yaml -o "
    "life.html\n"
    "  plsc view run1.sqlite best 17 -o run1.html\n"
    "  plsc view --editable examples/climber.pls -o climber.html\n"
    "  plsc view --explain examples/climber.pls --env flat --env tilted -o "
    "climber.html\n"
    "  plsc view --explain run1.sqlite best -o best.html";

}  // namespace

void Add(Options& options, ViewCommand& command) {
  options.Command("view", "Replay lives in 3-D, as a page for a browser");
  options
      .Add("INPUT", command.inputs,
           "recordings (plsc simulate --record), genotype files (which "
           "live now), or the store of a run followed by numbers of its "
           "robots, or best (default: best)")
      .Required();
  options.Add("-o,--output", command.output, "the page to write, HTML")
      .Required()
      .ValueName("FILE");
  AddForce(options, command.force);
  const Option scenario =
      options
          .Add("--scenario", command.scenario,
               "YAML file with the seasons and the physics for genotypes "
               "(default: the paper's, 50 s Flat then 50 s Tilted)")
          .ValueName("FILE");
  const Option engine =
      AddEngine(options, command.engine,
                "; recordings show what was lived, whatever it was");
  const Option explain = options
                             .Flag("--explain", command.explain,
                                   "instead of a replay, the page of how "
                                   "the robot developed: which rules "
                                   "are active, each rewriting, what each "
                                   "symbol did; of genotypes and "
                                   "runs")
                             .Excludes(scenario)
                             .Excludes(engine);
  options
      .Flag("--editable", command.editable,
            "instead of a replay, the page of plsc live as one file, with plsc "
            "in it: of one genotype file")
      .Excludes(explain)
      .Excludes(engine);
  options
      .Add("--env", command.environments,
           "with --explain: what the robot senses, STATE=VALUE,... or "
           "the name of an environment of the file, of a season of the "
           "run; may be repeated (default: all of them)")
      .ValueName("ENVIRONMENT")
      .Needs(explain);
  options
      .Flag("--allow-range", command.allow_range,
            "with --explain: arguments outside their range are warnings")
      .Needs(explain);
  options.Footer(kFooter);
}

}  // namespace plsc::cli
