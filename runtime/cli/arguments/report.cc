// Options and help of `plsc report`.

#include <CLI/CLI.hpp>

#include "runtime/cli/arguments/add_commands.h"

namespace plsc::cli {

CLI::App* AddReport(CLI::App& app, ReportCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "report", "Make a page with the figures and tests of a study or of runs");
  sub->add_option("STUDY|RUN", command.paths,
                  "folders of studies, of one experiment of a study, or of "
                  "runs; runs")
      ->option_text("STUDY|RUN...")
      ->required();
  sub->add_option("-o,--output", command.output,
                  "the page: one HTML file that needs nothing else")
      ->option_text("FILE");
  AddForce(sub, command.force);
  sub->add_option("--measures", command.measures,
                  "what is shown of robots: paper (default: Speed, Balance, "
                  "Size, Sensors, Sensors Reach, Recurrence), all, or names of "
                  "descriptors with commas between them")
      ->option_text("paper|all|NAME,...");
  sub->add_option("--format", command.format,
                  "html (default), or json: what the page shows, as one object")
      ->transform(CLI::CheckedTransformer(std::map<std::string, ReportFormat>{
          {"html", ReportFormat::kHtml}, {"json", ReportFormat::kJson}}))
      ->type_name("html|json")
      ->option_text("html|json");
  sub->add_flag("--verify", command.verify,
                "compare all results with their checksums first (about a "
                "second for 10,000 robots); what is damaged is left out");
  sub->add_flag("--quiet", command.quiet,
                "no progress and no summary; only what is wrong");
  sub->footer(
      "For each measure and season: curves over generations, box plots of the "
      "last\ngeneration, two-sided Wilcoxon rank-sum tests between "
      "experiments. And the best\nrobot of each run, how plastic populations "
      "are, and where the results come from\n(docs/reports.md). Runs may be "
      "unfinished, or worked on meanwhile. A run that is\ndamaged is told and "
      "left out.\n\n"
      "  plsc report small -o report.html\n"
      "  plsc report small/plastic small/baseline -o report.html\n"
      "  plsc report run1.sqlite --measures all -o run1.html\n"
      "  plsc report small --format json | jq '.tests[] | select(.p < 0.05)'"
      "\n\n"
      "Exit status: 0 fine, 1 a run is damaged or nothing can be read, 2 the "
      "usage is\nwrong.");
  return sub;
}

}  // namespace plsc::cli
