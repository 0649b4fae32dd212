// Options and help of the commands that keep house among genotypes.

#include <CLI/CLI.hpp>

#include "runtime/cli/arguments/add_commands.h"

namespace plsc::cli {

namespace {

void AddRange(CLI::App* command, bool& allow_range) {
  command->add_flag("--allow-range", allow_range,
                    "arguments outside their range are warnings, not errors");
}

void AddOutput(CLI::App* command, std::string& output, bool& force) {
  command
      ->add_option("-o,--output", output,
                   "file to write (default: standard output)")
      ->option_text("FILE");
  AddForce(command, force);
}

void AddFiles(CLI::App* command, std::vector<std::string>& files) {
  command
      ->add_option("FILE", files,
                   "genotype files; FILE#NAME is one of several genotypes; - "
                   "is standard input")
      ->required();
}

void AddEnvironmentsOf(CLI::App* command,
                       std::vector<std::string>& environments,
                       const char* otherwise) {
  command
      ->add_option("--env", environments,
                   std::string("STATE=VALUE,... or the name of an environment "
                               "of the file; may be repeated (default: ") +
                       otherwise + ")")
      ->option_text("ENVIRONMENT");
}

// What mutations and crossovers have in common.
template <typename One>
void AddStream(CLI::App* sub, One& command) {
  sub->add_option("--seed", command.stream.seed,
                  "the same numbers give the same child")
      ->required()
      ->check(CLI::NonNegativeNumber)
      ->option_text("N");
  sub->add_option("--generation", command.stream.generation,
                  "of the child in a run of that seed (default 0)")
      ->check(CLI::NonNegativeNumber)
      ->option_text("N");
  sub->add_option("--individual", command.stream.individual,
                  "the child's id in a run of that seed (default 0)")
      ->check(CLI::NonNegativeNumber)
      ->option_text("N");
  sub->add_option("--count", command.count,
                  "children, of ids that follow each other; in the text their "
                  "names end in _1, _2 and so on (default 1)")
      ->check(CLI::Range(1, 100000))
      ->option_text("N");
  sub->add_option("--experiment", command.experiment,
                  "YAML file of an experiment whose operators are meant "
                  "(default: the paper's)")
      ->option_text("FILE");
  AddOutput(sub, command.output, command.force);
  AddFormat(sub, command.format, "one child a line, with its text");
  AddRange(sub, command.allow_range);
}

}  // namespace

CLI::App* AddCross(CLI::App& app, CrossCommand& command) {
  CLI::App* sub =
      app.add_subcommand("cross", "Cross two genotypes, as evolution does");
  sub->add_option("FIRST", command.first,
                  "a genotype file; its states, settings and environments are "
                  "the child's")
      ->required();
  sub->add_option("SECOND", command.second, "a genotype file")->required();
  AddStream(sub, command);
  sub->footer(
      "For every replaceable symbol the child has all rules of one parent, "
      "each with\nprobability 1/2. Both parents have the same alphabet and "
      "sense the same. Says on\nstandard error what it did.\n\n"
      "  plsc cross a.pls b.pls --seed 1 > child.pls\n"
      "  plsc cross zoo.pls#a zoo.pls#b --seed 1 --count 10 --format json\n"
      "  plsc cross a.pls b.pls --seed 1 | plsc mutate - --seed 1");
  return sub;
}

CLI::App* AddHash(CLI::App& app, HashCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "hash", "Print a number of each genotype that layout does not change");
  AddFiles(sub, command.files);
  sub->add_flag("--phenotype", command.phenotype,
                "of the developed robots instead, FILE@ENVIRONMENT each");
  AddEnvironmentsOf(sub, command.environments,
                    "with --phenotype every environment that the file names");
  AddRange(sub, command.allow_range);
  sub->footer(
      "32 digits, two blanks and the file, as sha256sum prints them. Comments, "
      "layout,\nconstants, how numbers are written (1, 1.0), the order of "
      "states and of items,\nenvironments, tests and the name of the genotype "
      "do not count; alphabet, states,\naxiom, settings and rules do.\n\n"
      "  plsc hash robots/*.pls | sort | uniq -w 32 --all-repeated\n"
      "  plsc hash --phenotype robot.pls --env flat");
  return sub;
}

CLI::App* AddImport(CLI::App& app, ImportCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "import", "Translate a genotype of the authors' program");
  sub->add_option("FILE", command.file,
                  "a genotype of Revolve; - is standard input")
      ->required();
  sub->add_option("--format", command.from,
                  "auto (default) looks at the first character; repr: the one "
                  "line of Python that Revolve exports; lines: the older form, "
                  "a letter a line")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, ImportFormat>{{"auto", ImportFormat::kAuto},
                                              {"repr", ImportFormat::kRepr},
                                              {"lines", ImportFormat::kLines}}))
      ->type_name("auto|repr|lines")
      ->option_text("auto|repr|lines");
  sub->add_option("--name", command.name,
                  "of the genotype (default: the file's)")
      ->option_text("NAME");
  sub->add_option("--rename", command.renames,
                  "OLD=NEW: call a state otherwise, as in hill=inclined; may "
                  "be repeated")
      ->option_text("OLD=NEW");
  sub->add_flag("--unjoin", command.unjoin,
                "take off rules what Revolve joined to them in the level "
                "season, where it can be seen");
  AddOutput(sub, command.output, command.force);
  AddRange(sub, command.allow_range);
  sub->footer(
      "Names become the paper's (AJ1 is A2, AJ2 is A1) and the parameters of "
      "joints get\nits order, weight, amplitude, period, phase. What is lost "
      "or was lost before is\nsaid in warnings (W5200). The formats hold no "
      "settings: those of the paper are\nwritten, with its limits of terms and "
      "rules (max_terms, max_rules), or larger ones\nwhere the text has "
      "more.\n\n"
      "  plsc import genotype_robot_12.txt --rename hill=inclined -o r12.pls\n"
      "  plsc import old.txt --format lines | plsc develop -");
  return sub;
}

CLI::App* AddMutate(CLI::App& app, MutateCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "mutate", "Change one thing of a genotype at random, as evolution does");
  sub->add_option("FILE", command.file, "a genotype file; - is standard input")
      ->required();
  AddStream(sub, command);
  sub->footer(
      "Deletes, swaps or adds a symbol of one rule or changes its clause. Says "
      "on\nstandard error what it did; a deletion that meets C and the like "
      "change nothing,\nas in evolution. Environments are kept, tests are not. "
      "With the seed of a run, the\ngeneration and the id it is the mutation "
      "that this child had there.\n\n"
      "  plsc mutate robot.pls --seed 1 > mutant.pls\n"
      "  plsc mutate robot.pls --seed 1 --count 100 -o mutants.pls\n"
      "  plsc mutate robot.pls --seed 1 --format json | jq .mutation");
  return sub;
}

CLI::App* AddStats(CLI::App& app, StatsCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "stats", "Count what genotypes use: symbols, rules, modules, plasticity");
  AddFiles(sub, command.files);
  AddEnvironmentsOf(sub, command.environments,
                    "every environment that the file names, or else all that "
                    "clauses tell apart");
  AddFormat(sub, command.format, "one genotype a line");
  AddRange(sub, command.allow_range);
  sub->footer(
      "A symbol is expressed where it did something when the robot grew, or "
      "was\nreplaced by its rules before. Of each rule and environment: how "
      "often it was\napplied, how many of its symbols were expressed and how "
      "many modules they made.\nBodies are compared with the first "
      "environment's, place by place.\n\n"
      "  plsc stats robot.pls\n"
      "  plsc stats --format json robots/*.pls | jq '.expressed / .symbols'");
  return sub;
}

CLI::App* AddTrim(CLI::App& app, TrimCommand& command) {
  CLI::App* sub = app.add_subcommand(
      "trim", "Leave out what changes no robot in any environment");
  sub->add_option("FILE", command.file,
                  "a genotype file; FILE#NAME trims one of several genotypes; "
                  "- is standard input")
      ->required();
  CLI::Option* output =
      sub->add_option("-o,--output", command.output,
                      "file to write (default: standard output)")
          ->option_text("FILE");
  AddForce(sub, command.force);
  CLI::Option* write =
      sub->add_flag("--write", command.write, "replace FILE itself")
          ->excludes(output);
  sub->add_flag("--check", command.check,
                "write nothing; exit status 1 if anything would be left out")
      ->excludes(output)
      ->excludes(write);
  sub->add_option("--scenario", command.scenario,
                  "YAML file: only its seasons count as environments, as "
                  "simulate lives them")
      ->option_text("FILE");
  AddFormat(sub, command.format,
            "one object with the counts, the proof and the text");
  AddRange(sub, command.allow_range);
  sub->footer(
      "Leaves out rules, terms of clauses and symbols without which every "
      "environment\nthat clauses tell apart still develops into the same body "
      "and brain, ids and all\nnumbers included. The proof on standard error "
      "names the environments, with a hash\nof the robot before and after. "
      "Comments and layout of the rest stay; tests of the\nfile that pass go "
      "on to pass. Exit status 1, and nothing is written, if some\nenvironment "
      "cannot be developed.\nWith --scenario robots stay the same in its "
      "seasons, and may become others\nelsewhere.\n\n"
      "  plsc trim robot.pls > small.pls\n"
      "  plsc trim robot.pls --scenario hills.yaml > smaller.pls\n"
      "  plsc trim --write robots/robot7.pls\n"
      "  plsc trim robot.pls --format json | jq '.genotypes[].after'");
  return sub;
}

}  // namespace plsc::cli
