#include "runtime/cli/arguments/report.h"

#include "runtime/cli/arguments/common_options.h"
#include "runtime/cli/arguments/options.h"

namespace plsc::cli {

void Add(Options& options, ReportCommand& command) {
  options.Command(
      "report", "Make a page with the figures and tests of a study or of runs");
  options
      .Add("STUDY|RUN", command.paths,
           "folders of studies, of one experiment of a study, or of "
           "runs; runs; digests of studies")
      .ValueName("STUDY|RUN...")
      .Required();
  options
      .Add("-o,--output", command.output,
           "the page: one HTML file that needs nothing else")
      .ValueName("FILE");
  AddForce(options, command.force);
  options
      .Add("--measures", command.measures,
           "what is shown of robots: paper (default: Speed, Balance, "
           "Size, Sensors, Sensors Reach, Recurrence), all, or names of "
           "descriptors with commas between them")
      .ValueName("paper|all|NAME,...");
  options.Choice(
      "--format", command.format,
      "html (default); json: what the page shows, as one object; text: what "
      "became of the study's claims; files: into the folder -o tables (CSV, "
      "and tables.md) and figures (SVG), each replaced as a whole",
      {{"html", ReportFormat::kHtml},
       {"json", ReportFormat::kJson},
       {"text", ReportFormat::kText},
       {"files", ReportFormat::kFiles}});
  options.Flag("--verify", command.verify,
               "compare all results with their checksums first (about a "
               "second for 10,000 robots); what is damaged is left out");
  options
      .Add("--check-engine", command.check_engine,
           "live the N best robots of each run's last generation again by "
           "the engine that it did not have, and show how ranks and Speeds "
           "differ (seconds a robot if that is ODE)")
      .Range(1, 100000)
      .ValueName("N");
  options
      .Add("--relive", command.relive,
           "first let the survivors of the generation that is compared live "
           "again N times, as plsc relive does (default: what was lived "
           "again before is shown)")
      .Range(1, 100000)
      .ValueName("N");
  options.Flag("--quiet", command.quiet,
               "no progress and no summary; only what is wrong");
  options.Footer(
      "First what the study claims, and whether it holds. For each measure and "
      "season: curves over generations, box plots of the "
      "last\ngeneration, two-sided Wilcoxon rank-sum tests between "
      "experiments. And the best\nrobot of each run, how plastic populations "
      "are, and where the results come from\n(docs/reports.md). Where robots "
      "have lived again (plsc relive), these lives come\nbefore the recorded "
      "ones. Runs may be unfinished, or worked on meanwhile. A run that\nis "
      "damaged is told and left out.\n\n"
      "  plsc report small -o report.html\n"
      "  plsc report small --format text\n"
      "  plsc report paper.digest.json --format files -o figures\n"
      "  plsc report small/plastic small/baseline -o report.html\n"
      "  plsc report run1.sqlite --measures all -o run1.html\n"
      "  plsc report paper --check-engine 10 -o paper.html\n"
      "  plsc report paper --relive 20 -o paper.html\n"
      "  plsc report small --format json | jq '.tests[] | select(.p < 0.05)'"
      "\n\n"
      "Exit status: 0 fine, 1 a run is damaged or nothing can be read, 2 the "
      "usage is\nwrong, 130 stopped by Ctrl-C or SIGTERM while robots lived "
      "again.");
}

}  // namespace plsc::cli
