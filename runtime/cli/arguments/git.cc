// Options and help of the commands that compare and merge versions of
// genotypes, by hand or for git.

#include <CLI/CLI.hpp>

#include "runtime/cli/arguments/add_commands.h"

namespace plsc::cli {

CLI::App* AddDiff(CLI::App& app, DiffCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "diff", "Show what changed in genotypes, and in the robots they become");
  sub->add_option("FILE", command.files,
                  "OLD and NEW; FILE#NAME is a genotype of a file of several, "
                  "- standard input")
      ->required()
      ->option_text("OLD NEW");
  sub->add_option("--env", command.environments,
                  "compare robots in these environments only: a name that both "
                  "files declare, or state=value,...")
      ->option_text("ENVIRONMENT");
  AddFormat(sub, command.format, "one object");
  sub->add_option("--color", command.color,
                  "auto (default): on a terminal, unless NO_COLOR is set")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, ColorChoice>{{"auto", ColorChoice::kAuto},
                                             {"always", ColorChoice::kAlways},
                                             {"never", ColorChoice::kNever}}))
      ->type_name("auto|always|never")
      ->option_text("auto|always|never");
  sub->add_flag("--allow-range", command.allow_range,
                "arguments outside their range are warnings, not errors");
  sub->add_flag("--git", command.is_git,
                "take what git passes to an external diff, and answer as it "
                "wants it: always with exit status 0");
  sub->footer(
      "Rules are matched by what they say, wherever they stand; within a rule "
      "symbols\nand their arguments are compared. Then both genotypes are "
      "developed in every\nenvironment that their clauses tell apart, and "
      "bodies and brains compared.\n\n"
      "Exit status, as of diff(1): 0 no robot differs in any environment (the "
      "texts\nmay), 1 some robot does, 2 trouble: a file is unreadable or "
      "wrong.\n\n"
      "  plsc diff gecko.pls faster.pls\n"
      "  plsc diff zoo.pls#gecko zoo.pls#snake --env inclined=True\n"
      "  git config diff.plsc.command 'plsc diff --git --'\n"
      "  echo '*.pls diff=plsc merge=plsc' >> .gitattributes");
  return sub;
}

CLI::App* AddMerge(CLI::App& app, MergeCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "merge", "Merge two versions of a genotype file by rules and symbols");
  sub->add_option("BASE", command.base,
                  "what both come from; an empty file if nothing")
      ->required();
  sub->add_option("OURS", command.ours, "one version")->required();
  sub->add_option("THEIRS", command.theirs, "the other")->required();
  CLI::Option* output = sub->add_option("-o,--output", command.output,
                                        "write here, not to standard output");
  output->option_text("FILE");
  AddForce(sub, command.force);
  CLI::Option* write =
      sub->add_flag("--write-ours", command.write_ours, "replace OURS");
  output->excludes(write);
  sub->add_flag("--driver", command.is_driver,
                "as git's merge driver: replaces OURS")
      ->excludes(output);
  sub->add_option("-L", command.marker_size,
                  "characters of a conflict marker (default 7); git's %L")
      ->check(CLI::Range(1, 1000))
      ->option_text("N");
  sub->add_option("-P,--path", command.path,
                  "the file's name in messages; git's %P")
      ->option_text("PATH");
  sub->add_option("--label", command.labels,
                  "up to three times: names of ours, base and theirs in "
                  "messages and markers")
      ->option_text("NAME");
  sub->add_flag("--allow-range", command.allow_range,
                "arguments outside their range are warnings, not errors");
  sub->footer(
      "Items are known by their names, rules by what they say; within a rule "
      "symbols,\nterms and arguments are merged one by one. Only what both "
      "changed in different\nways is a conflict, and then that rule or item "
      "gets git's markers. What merges\nwithout conflict is compiled.\n\n"
      "Exit status: 0 merged, 1 conflicts (or what was merged is wrong: told "
      "why), 2\ntrouble: a file is unreadable or wrong, and nothing is "
      "written. With --driver\nlines are merged where a version is no correct "
      "genotype, so that neither side\nis lost.\n\n"
      "  plsc merge base.pls mine.pls yours.pls -o merged.pls\n"
      "  git config merge.plsc.driver "
      "'plsc merge --driver -L %L --path=%P -- %O %A %B'\n"
      "  echo '*.pls diff=plsc merge=plsc' >> .gitattributes");
  return sub;
}

}  // namespace plsc::cli
