// Options and help of the commands that look at genotypes as texts.

#include <CLI/CLI.hpp>

#include "runtime/cli/arguments/add_commands.h"

namespace plsc::cli {

CLI::App* AddCheck(CLI::App& app, CheckCommand& command) {
  CLI::App* sub = app.add_subcommand("check", "Say whether files are correct");
  sub->add_option("FILE", command.files,
                  "genotypes, experiments, scenarios, studies, golden files, "
                  "recordings; - is standard input")
      ->required();
  sub->add_option("--format", command.format,
                  "text for people (default); json: one diagnostic a line; "
                  "sarif: one SARIF 2.1.0 document; github: annotations of "
                  "GitHub Actions")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, CheckFormat>{{"text", CheckFormat::kText},
                                             {"json", CheckFormat::kJson},
                                             {"sarif", CheckFormat::kSarif},
                                             {"github", CheckFormat::kGithub}}))
      ->type_name("text|json|sarif|github")
      ->option_text("text|json|sarif|github");
  sub->add_flag("--allow-range", command.allow_range,
                "arguments outside their range are warnings, not errors");
  sub->add_option("--color", command.color,
                  "auto (default): on a terminal, unless NO_COLOR is set")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, ColorChoice>{{"auto", ColorChoice::kAuto},
                                             {"always", ColorChoice::kAlways},
                                             {"never", ColorChoice::kNever}}))
      ->type_name("auto|always|never")
      ->option_text("auto|always|never");
  sub->add_option("--max-errors", command.max_errors,
                  "most diagnostics that text shows of a file (default 20); 0 "
                  "shows all")
      ->check(CLI::Range(0, 1000000))
      ->option_text("N");
  sub->add_flag("--lint", command.lint,
                "also show the warnings of 'plsc lint'; they change no exit "
                "status");
  sub->footer(
      "Prints every error that can be found, with file:line:column, the line, "
      "a caret\nand what was expected. Exit status 1 if there is any. What a "
      "file is its text\ntells; of an experiment or a study the scenarios that "
      "it names are checked, too.\n\n"
      "  plsc check robots/*.pls\n"
      "  plsc check experiment.yaml\n"
      "  plsc check --format json robot.pls | jq .message\n"
      "  plsc check --format github robots/*.pls    in a workflow\n\n"
      "'plsc explain CODE' says more of a code; 'plsc fix' mends what it can.");
  return sub;
}

CLI::App* AddExplain(CLI::App& app, ExplainCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "explain", "Explain a diagnostic's code, with an example mended");
  sub->add_option("CODE", command.code, "as in error[P2001]");
  sub->add_flag("--list", command.list, "all codes, one a line");
  AddFormat(sub, command.format, "one object a code");
  sub->footer(
      "  plsc explain P2001\n"
      "  plsc explain --list");
  return sub;
}

CLI::App* AddFix(CLI::App& app, FixCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "fix", "Mend errors whose mending the diagnostics know");
  sub->add_option("FILE", command.files,
                  "genotype files, rewritten in place; - is standard input, "
                  "printed")
      ->required();
  sub->add_flag("--check", command.check,
                "write nothing; exit status 1 if anything would be mended");
  sub->add_flag("--diff", command.diff,
                "write nothing; print what would change as a unified diff; "
                "exit status 1 if anything would")
      ->excludes("--check");
  sub->add_flag("--allow-range", command.allow_range,
                "arguments outside their range are warnings, not errors");
  sub->footer(
      "Makes the replacements that 'plsc check' proposes (\"did you mean\", "
      "\"write\",\n\"insert\"), compiles again, and goes on until nothing more "
      "can be mended. Says\nwhat it changed and what is left. A file is "
      "replaced as a whole or not at all,\nand never by one with more errors. "
      "Exit status 1 if errors remain.\n\n"
      "  plsc fix robot.pls\n"
      "  plsc fix --check robots/*.pls\n"
      "  plsc fix --diff robot.pls\n"
      "  plsc fix - < robot.pls > mended.pls");
  return sub;
}

CLI::App* AddFmt(CLI::App& app, FmtCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "fmt", "Rewrite files in the canonical layout, comments kept");
  sub->add_option("FILE", command.files,
                  "genotype files, rewritten in place; - is standard input, "
                  "printed")
      ->required();
  sub->add_flag("--check", command.check,
                "write nothing; exit status 1 names files that would change");
  sub->add_flag("--diff", command.diff,
                "write nothing; print what would change as a unified diff; "
                "exit status 1 if anything would")
      ->excludes("--check");
  sub->add_flag("--stdout", command.to_stdout,
                "print the result instead of writing the file");
  sub->add_flag("--compact", command.compact,
                "a group of symbols a line instead of one symbol a line");
  sub->footer(
      "The canonical layout has one symbol a line, so that git merges two "
      "independent\nmutations without conflict. A file is replaced as a whole "
      "or not at all, and only\nwhen the new text means the same genotype.");
  return sub;
}

CLI::App* AddLint(CLI::App& app, LintCommand& command) {
  CLI::App* sub =
      app.add_subcommand("lint", "Warn of what is right but may not be meant");
  sub->add_option("FILE", command.files, "genotype files; - is standard input")
      ->required();
  AddFormat(sub, command.format, "one diagnostic a line");
  sub->add_flag("--deny", command.deny, "exit status 1 if there is a warning");
  sub->add_flag("--allow-range", command.allow_range,
                "arguments outside their range are warnings, not errors");
  sub->footer(
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
  return sub;
}

}  // namespace plsc::cli
