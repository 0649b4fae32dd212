// Options and help of the pages that show robots.

#include <CLI/CLI.hpp>

#include "runtime/cli/arguments/add_commands.h"

namespace plsc::cli {

CLI::App* AddView(CLI::App& app, ViewCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "view", "Replay lives in 3-D, as a page for a browser");
  sub->add_option("INPUT", command.inputs,
                  "recordings (plsc simulate --record), genotype files (which "
                  "live now), or the store of a run followed by numbers of its "
                  "robots, or best (default: best)")
      ->required();
  sub->add_option("-o,--output", command.output, "the page to write, HTML")
      ->required()
      ->option_text("FILE");
  AddForce(sub, command.force);
  CLI::Option* scenario =
      sub->add_option(
             "--scenario", command.scenario,
             "YAML file with the seasons and the physics for genotypes "
             "(default: the paper's, 50 s Flat then 50 s Tilted)")
          ->option_text("FILE");
  CLI::Option* explain = sub->add_flag("--explain", command.explain,
                                       "instead of a replay, the page of how "
                                       "the robot developed: which rules "
                                       "are active, each rewriting, what each "
                                       "symbol did; of genotypes and "
                                       "runs")
                             ->excludes(scenario);
  sub->add_option("--env", command.environments,
                  "with --explain: what the robot senses, STATE=VALUE,... or "
                  "the name of an environment of the file, of a season of the "
                  "run; may be repeated (default: all of them)")
      ->option_text("ENVIRONMENT")
      ->needs(explain);
  sub->add_flag("--allow-range", command.allow_range,
                "with --explain: arguments outside their range are warnings")
      ->needs(explain);
  sub->footer(
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
      "  plsc view --explain examples/climber.pls --env flat --env tilted -o "
      "climber.html\n"
      "  plsc view --explain run1.sqlite best -o best.html");
  return sub;
}

}  // namespace plsc::cli
