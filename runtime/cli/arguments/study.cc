// Options and help of `plsc study`.

#include <CLI/CLI.hpp>

#include "runtime/cli/arguments/add_commands.h"
#include "runtime/study/slice.h"

namespace plsc::cli {

namespace {

void AddSlice(CLI::App* sub, std::string& only, std::string& shard) {
  sub->add_option("--only", only,
                  "only the runs of this experiment, or only this run of it")
      ->option_text("NAME[/N]");
  sub->add_option("--shard", shard,
                  "only the K-th of N equal parts of the study: every N-th run "
                  "of the list, from the K-th on")
      ->check(CLI::Validator(
          [](const std::string& text) {
            return ParseShard(text)
                       ? std::string()
                       : "expected K/N with K of 1 to N, found '" + text + "'";
          },
          ""))
      ->option_text("K/N");
}

}  // namespace

CLI::App* AddStudy(CLI::App& app) {
  CLI::App* study = app.add_subcommand(
      "study", "Do many runs of evolution that one file describes");
  study->require_subcommand(1);
  study->footer(
      "A study is some experiments, each repeated with other seeds "
      "(docs/studies.md).\n\n"
      "  plsc study list examples/small_study.yaml\n"
      "  plsc study run examples/small_study.yaml -o small\n"
      "  plsc study status small");
  return study;
}

CLI::App* AddStudyList(CLI::App& study, StudyListCommand& command) {
  CLI::App* sub = study.add_subcommand("list", "Show which runs a study has");
  sub->add_option("STUDY", command.study, "YAML file of the study")->required();
  AddSlice(sub, command.only, command.shard);
  AddFormat(sub, command.format, "one run a line");
  sub->footer(
      "Nothing is run. Seeds follow from the study's seed, the experiment's "
      "name and the\nrepetition.\n\n"
      "  plsc study list examples/paper_study.yaml\n"
      "  plsc study list examples/paper_study.yaml --shard 2/8");
  return sub;
}

CLI::App* AddStudyRun(CLI::App& study, StudyRunCommand& command) {
  CLI::App* sub =
      study.add_subcommand("run", "Do a study's runs, all of them or a part");
  sub->add_option("STUDY", command.study, "YAML file of the study")->required();
  sub->add_option("-o,--output", command.output,
                  "the study's folder, made if it is not there; a run is "
                  "FOLDER/EXPERIMENT/N.sqlite")
      ->option_text("FOLDER")
      ->required();
  AddSlice(sub, command.only, command.shard);
  sub->add_option("--jobs", command.jobs,
                  "worker processes of a run (0 and default: one a core that "
                  "may be used); changes no result")
      ->check(CLI::Range(0, 1024))
      ->option_text("N");
  sub->add_option("--cache", command.cache,
                  "look simulations up in this file first and add new ones to "
                  "it; changes no result")
      ->option_text("FILE");
  sub->add_flag("--allow-other-version", command.allow_other_version,
                "go on with runs that another version of plsc began");
  sub->add_flag("--quiet", command.quiet,
                "no progress; only what is wrong, and a summary");
  sub->footer(
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
  return sub;
}

CLI::App* AddStudyStatus(CLI::App& study, StudyStatusCommand& command) {
  CLI::App* sub =
      study.add_subcommand("status", "Show how far the runs of a study are");
  sub->add_option("FOLDER", command.folder, "the study's folder")->required();
  AddFormat(sub, command.format, "one run a line");
  sub->footer(
      "Works while runs go on, and changes nothing. Speeds are those of the "
      "best robot of\nthe last generation. States: done, running (a process "
      "works on it), unfinished\n(stopped or killed), missing (not begun), "
      "damaged.\n\n"
      "  plsc study status paper\n"
      "  plsc study status paper --format json | jq -c "
      "'select(.state == \"damaged\")'\n\n"
      "Exit status: 0 fine, 1 a run is damaged.");
  return sub;
}

}  // namespace plsc::cli
