#include "runtime/cli/arguments/texts.h"

#include "runtime/cli/arguments/common_options.h"
#include "runtime/cli/arguments/options.h"

namespace plsc::cli {

void Add(Options& options, CheckCommand& command) {
  options.Command("check", "Say whether files are correct");
  options
      .Add("FILE", command.files,
           "genotypes, experiments, scenarios, studies, golden files, "
           "recordings; - is standard input")
      .Required();
  options.Choice("--format", command.format,
                 "text for people (default); json: one diagnostic a line; "
                 "sarif: one SARIF 2.1.0 document; github: annotations of "
                 "GitHub Actions",
                 {{"text", CheckFormat::kText},
                  {"json", CheckFormat::kJson},
                  {"sarif", CheckFormat::kSarif},
                  {"github", CheckFormat::kGithub}});
  AddAllowRange(options, command.allow_range);
  AddColor(options, command.color);
  options
      .Add("--max-errors", command.max_errors,
           "most diagnostics that text shows of a file (default 20); 0 "
           "shows all")
      .Range(0, 1000000)
      .ValueName("N");
  options.Flag("--lint", command.lint,
               "also show the warnings of 'plsc lint'; they change no exit "
               "status");
  options.Footer(
      "Prints every error that can be found, with file:line:column, the line, "
      "a caret\nand what was expected. Exit status 1 if there is any. What a "
      "file is its text\ntells; of an experiment or a study the scenarios that "
      "it names are checked, too.\n\n"
      "  plsc check robots/*.pls\n"
      "  plsc check experiment.yaml\n"
      "  plsc check --format json robot.pls | jq .message\n"
      "  plsc check --format github robots/*.pls    in a workflow\n\n"
      "'plsc explain CODE' says more of a code; 'plsc fix' mends what it can.");
}

void Add(Options& options, ExplainCommand& command) {
  options.Command("explain",
                  "Explain a diagnostic's code, with an example mended");
  options.Add("CODE", command.code, "as in error[P2001]");
  options.Flag("--list", command.list, "all codes, one a line");
  AddFormat(options, command.format, "one object a code");
  options.Footer(
      "  plsc explain P2001\n"
      "  plsc explain --list");
}

void Add(Options& options, FixCommand& command) {
  options.Command("fix", "Mend errors whose mending the diagnostics know");
  options
      .Add("FILE", command.files,
           "genotype files, rewritten in place; - is standard input, "
           "printed")
      .Required();
  const Option check =
      options.Flag("--check", command.check,
                   "write nothing; exit status 1 if anything would be mended");
  options
      .Flag("--diff", command.diff,
            "write nothing; print what would change as a unified diff; "
            "exit status 1 if anything would")
      .Excludes(check);
  AddAllowRange(options, command.allow_range);
  options.Footer(
      "Makes the replacements that 'plsc check' proposes (\"did you mean\", "
      "\"write\",\n\"insert\"), compiles again, and goes on until nothing more "
      "can be mended. Says\nwhat it changed and what is left. A file is "
      "replaced as a whole or not at all,\nand never by one with more errors. "
      "Exit status 1 if errors remain.\n\n"
      "  plsc fix robot.pls\n"
      "  plsc fix --check robots/*.pls\n"
      "  plsc fix --diff robot.pls\n"
      "  plsc fix - < robot.pls > mended.pls");
}

void Add(Options& options, FmtCommand& command) {
  options.Command("fmt",
                  "Rewrite files in the canonical layout, comments kept");
  options
      .Add("FILE", command.files,
           "genotype files, rewritten in place; - is standard input, "
           "printed")
      .Required();
  const Option check = options.Flag(
      "--check", command.check,
      "write nothing; exit status 1 names files that would change");
  options
      .Flag("--diff", command.diff,
            "write nothing; print what would change as a unified diff; "
            "exit status 1 if anything would")
      .Excludes(check);
  options.Flag("--stdout", command.to_stdout,
               "print the result instead of writing the file");
  options.Flag("--compact", command.compact,
               "a group of symbols a line instead of one symbol a line");
  options.Footer(
      "The canonical layout has one symbol a line, so that git merges two "
      "independent\nmutations without conflict. A file is replaced as a whole "
      "or not at all, and only\nwhen the new text means the same genotype.");
}

void Add(Options& options, LintCommand& command) {
  options.Command("lint", "Warn of what is right but may not be meant");
  options.Add("FILE", command.files, "genotype files; - is standard input")
      .Required();
  AddFormat(options, command.format, "one diagnostic a line");
  options.Flag("--deny", command.deny, "exit status 1 if there is a warning");
  AddAllowRange(options, command.allow_range);
  options.Footer(
      "Looks at every environment that the clauses can tell apart, and "
      "develops there:\nclauses that are always true or never (W3002), "
      "environments in which no rule of a\nsymbol is active (W3003) or several "
      "at once (W3004), strings that would grow too\nlong (W4001), symbols and "
      "rules that never do anything (W4002), commands that\nchange another "
      "joint "
      "than the one before them (W4003), rules of C that are read\nseveral "
      "times in one place (W4004). A comment '# plsc: allow W3003' before an "
      "item\nor behind it silences a warning there, '# plsc: allow-file W3003' "
      "in the whole\nfile. Exit status 0 with warnings, 1 with errors or, with "
      "--deny, with any warning.\n\n"
      "  plsc lint robots/*.pls\n"
      "  plsc lint --deny --format json robot.pls | jq .message");
}

}  // namespace plsc::cli
