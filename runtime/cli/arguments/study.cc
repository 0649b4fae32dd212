#include "runtime/cli/arguments/study.h"

#include "runtime/cli/arguments/common_options.h"
#include "runtime/cli/arguments/options.h"
#include "runtime/study/slice.h"

namespace plsc::cli {

namespace {

void AddToStudy(Options& options, const char* name, const char* summary) {
  options.Group("study", "Do many runs of evolution that one file describes",
                "A study is some experiments, each repeated with other seeds "
                "(docs/studies.md).\n\n"
                "  plsc study list examples/small_study.yaml\n"
                "  plsc study run examples/small_study.yaml -o small\n"
                "  plsc study status small");
  options.Command(name, summary);
}

std::string CheckShard(const std::string& text) {
  return ParseShard(text)
             ? ""
             : "expected K/N with K of 1 to N, found '" + text + "'";
}

void AddSlice(Options& options, std::string& only, std::string& shard) {
  options
      .Add("--only", only,
           "only the runs of this experiment, or only this run of it")
      .ValueName("NAME[/N]");
  options
      .Add("--shard", shard,
           "only the K-th of N equal parts of the study: every N-th run "
           "of the list, from the K-th on")
      .Check(CheckShard)
      .ValueName("K/N");
}

}  // namespace

void Add(Options& options, StudyListCommand& command) {
  AddToStudy(options, "list", "Show which runs a study has");
  options.Add("STUDY", command.study, "YAML file of the study").Required();
  AddSlice(options, command.only, command.shard);
  AddFormat(options, command.format, "one run a line");
  options.Footer(
      "Nothing is run. Seeds follow from the study's seed, the experiment's "
      "name and the\nrepetition.\n\n"
      "  plsc study list examples/paper_study.yaml\n"
      "  plsc study list examples/paper_study.yaml --shard 2/8");
}

void Add(Options& options, StudyRunCommand& command) {
  AddToStudy(options, "run", "Do a study's runs, all of them or a part");
  options.Add("STUDY", command.study, "YAML file of the study").Required();
  options
      .Add("-o,--output", command.output,
           "the study's folder, made if it is not there; a run is "
           "FOLDER/EXPERIMENT/N.sqlite")
      .ValueName("FOLDER")
      .Required();
  AddSlice(options, command.only, command.shard);
  AddEngine(options, command.engine,
            "; a folder is of one engine, and of no other study");
  AddJobs(options, command.jobs,
          "worker processes of a run (0 and default: one a core that "
          "may be used); changes no result");
  options
      .Add("--cache", command.cache,
           "look simulations up in this file first and add new ones to "
           "it; changes no result")
      .ValueName("FILE");
  options.Flag("--allow-other-version", command.allow_other_version,
               "go on with runs that another version of plsc began");
  options.Flag("--quiet", command.quiet,
               "no progress; only what is wrong, and a summary");
  options.Footer(
      "Begins runs that are missing, goes on with those that were stopped or "
      "killed, and\nleaves those that are done, or that another process works "
      "on: the same command\nagain does what is left. Several processes, also "
      "on several hosts that see the\nfolder, may share a study. The folder "
      "keeps the study, and takes no other.\n\n"
      "  plsc study run examples/small_study.yaml -o small\n"
      "  plsc study run examples/paper_study.yaml -o paper --only plastic/3\n"
      "  plsc study run examples/paper_study.yaml -o paper --shard 2/8\n\n"
      "Exit status: 0 everything in the part is done or worked on by others, 1 "
      "something\nis wrong, 130 stopped by Ctrl-C or SIGTERM.");
}

void Add(Options& options, StudyStatusCommand& command) {
  AddToStudy(options, "status", "Show how far the runs of a study are");
  options.Add("FOLDER", command.folder, "the study's folder").Required();
  AddFormat(options, command.format, "one run a line");
  options.Footer(
      "Works while runs go on, and changes nothing. Speeds are those of the "
      "best robot of\nthe last generation. States: done, running (a process "
      "works on it), unfinished\n(stopped or killed), missing (not begun), "
      "damaged. Below them: when the study's claims were stated, and "
      "changed.\n\n"
      "  plsc study status paper\n"
      "  plsc study status paper --format json | jq -c "
      "'select(.state == \"damaged\")'\n\n"
      "Exit status: 0 fine, 1 a run, or what was claimed, is damaged.");
}

void Add(Options& options, StudyDigestCommand& command) {
  AddToStudy(options, "digest",
             "Keep what a study's report needs in one small text");
  options.Add("FOLDER", command.folder, "the study's folder").Required();
  options
      .Add("-o,--output", command.output,
           "the digest; one that is there, of the same study, keeps its runs "
           "and takes those that are new")
      .Required()
      .ValueName("FILE");
  AddForce(options, command.force);
  options
      .Add("--measures", command.measures,
           "what is kept of robots: paper (default), all, or names of "
           "descriptors with commas between them; of a digest that is there "
           "what it has")
      .ValueName("paper|all|NAME,...");
  options
      .Add("--every", command.every,
           "generations between those that are kept (default: 10); the last "
           "always is")
      .Range(1, 1000000)
      .ValueName("N");
  options.Flag("--quiet", command.quiet, "no summary; only what is wrong");
  options.Footer(
      "Stores of a large study are gigabytes; its digest is some 7 KB a run, "
      "a line each,\nand can be committed beside a paper: 'plsc report FILE' "
      "makes the figures and tests\nof it again. Each line has the seed, the "
      "version, the command that makes the store\nanew, and the best robot's "
      "genotype. Only runs that are done are kept; those of\nother folders of "
      "the same study, or of later days, join them.\n\n"
      "  plsc study digest paper -o paper.digest.json\n"
      "  plsc report paper.digest.json -o report.html\n\n"
      "Exit status: 0 fine, 1 a run is damaged or is left out.");
}

}  // namespace plsc::cli
