#include "runtime/cli/arguments/genotypes.h"

#include "runtime/cli/arguments/common_options.h"
#include "runtime/cli/arguments/options.h"

namespace plsc::cli {

namespace {

void AddFiles(Options& options, std::vector<std::string>& files) {
  options
      .Add("FILE", files,
           "genotype files; FILE#NAME is one of several genotypes; - "
           "is standard input")
      .Required();
}

void AddEnvironmentsOf(Options& options, std::vector<std::string>& environments,
                       const char* otherwise) {
  options
      .Add("--env", environments,
           std::string("STATE=VALUE,... or the name of an environment "
                       "of the file; may be repeated (default: ") +
               otherwise + ")")
      .ValueName("ENVIRONMENT");
}

// What mutations and crossovers have in common.
template <typename One>
void AddStream(Options& options, One& command) {
  options
      .Add("--seed", command.stream.seed,
           "the same numbers give the same child")
      .Required()
      .NotNegative()
      .ValueName("N");
  options
      .Add("--generation", command.stream.generation,
           "of the child in a run of that seed (default 0)")
      .NotNegative()
      .ValueName("N");
  options
      .Add("--individual", command.stream.individual,
           "the child's id in a run of that seed (default 0)")
      .NotNegative()
      .ValueName("N");
  options
      .Add("--count", command.count,
           "children, of ids that follow each other; in the text their "
           "names end in _1, _2 and so on (default 1)")
      .Range(1, 100000)
      .ValueName("N");
  options
      .Add("--experiment", command.experiment,
           "YAML file of an experiment whose operators are meant "
           "(default: the paper's)")
      .ValueName("FILE");
  AddOutput(options, command.output, command.force);
  AddFormat(options, command.format, "one child a line, with its text");
  AddAllowRange(options, command.allow_range);
}

}  // namespace

void Add(Options& options, CrossCommand& command) {
  options.Command("cross", "Cross two genotypes, as evolution does");
  options
      .Add("FIRST", command.first,
           "a genotype file; its states, settings and environments are "
           "the child's")
      .Required();
  options.Add("SECOND", command.second, "a genotype file").Required();
  AddStream(options, command);
  options.Footer(
      "For every replaceable symbol the child has all rules of one parent, "
      "each with\nprobability 1/2. Both parents have the same alphabet and "
      "sense the same. Says on\nstandard error what it did.\n\n"
      "  plsc cross a.pls b.pls --seed 1 > child.pls\n"
      "  plsc cross zoo.pls#a zoo.pls#b --seed 1 --count 10 --format json\n"
      "  plsc cross a.pls b.pls --seed 1 | plsc mutate - --seed 1");
}

void Add(Options& options, HashCommand& command) {
  options.Command(
      "hash", "Print a number of each genotype that layout does not change");
  AddFiles(options, command.files);
  options.Flag("--phenotype", command.phenotype,
               "of the developed robots instead, FILE@ENVIRONMENT each");
  AddEnvironmentsOf(options, command.environments,
                    "with --phenotype every environment that the file names");
  AddAllowRange(options, command.allow_range);
  options.Footer(
      "32 digits, two blanks and the file, as sha256sum prints them. Comments, "
      "layout,\nconstants, how numbers are written (1, 1.0), the order of "
      "states and of items,\nenvironments, tests and the name of the genotype "
      "do not count; alphabet, states,\naxiom, settings and rules do.\n\n"
      "  plsc hash robots/*.pls | sort | uniq -w 32 --all-repeated\n"
      "  plsc hash --phenotype robot.pls --env flat");
}

void Add(Options& options, ImportCommand& command) {
  options.Command("import", "Translate a genotype of the authors' program");
  options
      .Add("FILE", command.file, "a genotype of Revolve; - is standard input")
      .Required();
  options.Choice("--format", command.from,
                 "auto (default) looks at the first character; repr: the one "
                 "line of Python that Revolve exports; lines: the older form, "
                 "a letter a line",
                 {{"auto", ImportFormat::kAuto},
                  {"repr", ImportFormat::kRepr},
                  {"lines", ImportFormat::kLines}});
  options.Add("--name", command.name, "of the genotype (default: the file's)")
      .ValueName("NAME");
  options
      .Add("--rename", command.renames,
           "OLD=NEW: call a state otherwise, as in hill=inclined; may "
           "be repeated")
      .ValueName("OLD=NEW");
  options.Flag("--unjoin", command.unjoin,
               "take off rules what Revolve joined to them in the level "
               "season, where it can be seen");
  AddOutput(options, command.output, command.force);
  AddAllowRange(options, command.allow_range);
  options.Footer(
      "Names become the paper's (AJ1 is A2, AJ2 is A1) and the parameters of "
      "joints get\nits order, weight, amplitude, period, phase. What is lost "
      "or was lost before is\nsaid in warnings (W5200). The formats hold no "
      "settings: those of the paper are\nwritten, with its limits of terms and "
      "rules (max_terms, max_rules), or larger ones\nwhere the text has "
      "more.\n\n"
      "  plsc import genotype_robot_12.txt --rename hill=inclined -o r12.pls\n"
      "  plsc import old.txt --format lines | plsc develop -");
}

void Add(Options& options, MutateCommand& command) {
  options.Command(
      "mutate", "Change one thing of a genotype at random, as evolution does");
  options.Add("FILE", command.file, "a genotype file; - is standard input")
      .Required();
  AddStream(options, command);
  options.Footer(
      "Deletes, swaps or adds a symbol of one rule or changes its clause. Says "
      "on\nstandard error what it did; a deletion that meets C and the like "
      "change nothing,\nas in evolution. Environments are kept, tests are not. "
      "With the seed of a run, the\ngeneration and the id it is the mutation "
      "that this child had there.\n\n"
      "  plsc mutate robot.pls --seed 1 > mutant.pls\n"
      "  plsc mutate robot.pls --seed 1 --count 100 -o mutants.pls\n"
      "  plsc mutate robot.pls --seed 1 --format json | jq .mutation");
}

void Add(Options& options, StatsCommand& command) {
  options.Command(
      "stats", "Count what genotypes use: symbols, rules, modules, plasticity");
  AddFiles(options, command.files);
  AddEnvironmentsOf(options, command.environments,
                    "every environment that the file names, or else all that "
                    "clauses tell apart");
  AddFormat(options, command.format, "one genotype a line");
  AddAllowRange(options, command.allow_range);
  options.Footer(
      "A symbol is expressed where it did something when the robot grew, or "
      "was\nreplaced by its rules before. Of each rule and environment: how "
      "often it was\napplied, how many of its symbols were expressed and how "
      "many modules they made.\nBodies are compared with the first "
      "environment's, place by place.\n\n"
      "  plsc stats robot.pls\n"
      "  plsc stats --format json robots/*.pls | jq '.expressed / .symbols'");
}

void Add(Options& options, TrimCommand& command) {
  options.Command("trim", "Leave out what changes no robot in any environment");
  options
      .Add("FILE", command.file,
           "a genotype file; FILE#NAME trims one of several genotypes; "
           "- is standard input")
      .Required();
  const Option output = AddOutput(options, command.output, command.force);
  const Option write =
      options.Flag("--write", command.write, "replace FILE itself")
          .Excludes(output);
  options
      .Flag("--check", command.check,
            "write nothing; exit status 1 if anything would be left out")
      .Excludes(output)
      .Excludes(write);
  options
      .Add("--scenario", command.scenario,
           "YAML file: only its seasons count as environments, as "
           "simulate lives them")
      .ValueName("FILE");
  AddFormat(options, command.format,
            "one object with the counts, the proof and the text");
  AddAllowRange(options, command.allow_range);
  options.Footer(
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
}

}  // namespace plsc::cli
