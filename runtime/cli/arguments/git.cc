#include "runtime/cli/arguments/git.h"

#include "runtime/cli/arguments/common_options.h"
#include "runtime/cli/arguments/options.h"

namespace plsc::cli {

void Add(Options& options, DiffCommand& command) {
  options.Command(
      "diff", "Show what changed in genotypes, and in the robots they become");
  options
      .Add("FILE", command.files,
           "OLD and NEW; FILE#NAME is a genotype of a file of several, "
           "- standard input")
      .Required()
      .ValueName("OLD NEW");
  options
      .Add("--env", command.environments,
           "compare robots in these environments only: a name that both "
           "files declare, or state=value,...")
      .ValueName("ENVIRONMENT");
  AddFormat(options, command.format, "one object");
  AddColor(options, command.color);
  AddAllowRange(options, command.allow_range);
  options.Flag("--git", command.is_git,
               "take what git passes to an external diff, and answer as it "
               "wants it: always with exit status 0");
  options.Footer(
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
}

void Add(Options& options, MergeCommand& command) {
  options.Command("merge",
                  "Merge two versions of a genotype file by rules and symbols");
  options
      .Add("BASE", command.base,
           "what both come from; an empty file if nothing")
      .Required();
  options.Add("OURS", command.ours, "one version").Required();
  options.Add("THEIRS", command.theirs, "the other").Required();
  const Option output = options.Add("-o,--output", command.output,
                                    "write here, not to standard output");
  output.ValueName("FILE");
  AddForce(options, command.force);
  const Option write =
      options.Flag("--write-ours", command.write_ours, "replace OURS");
  output.Excludes(write);
  options
      .Flag("--driver", command.is_driver,
            "as git's merge driver: replaces OURS")
      .Excludes(output);
  options
      .Add("-L", command.marker_size,
           "characters of a conflict marker (default 7); git's %L")
      .Range(1, 1000)
      .ValueName("N");
  options
      .Add("-P,--path", command.path, "the file's name in messages; git's %P")
      .ValueName("PATH");
  options
      .Add("--label", command.labels,
           "up to three times: names of ours, base and theirs in "
           "messages and markers")
      .ValueName("NAME");
  AddAllowRange(options, command.allow_range);
  options.Footer(
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
}

}  // namespace plsc::cli
