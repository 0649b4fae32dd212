#include "runtime/vary/mutate.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>

#include "compiler/print.h"
#include "grammar/shown_line.h"
#include "runtime/cli/arguments/genotypes.h"
#include "runtime/cli/commands/offspring.h"
#include "runtime/cli/files/load_program.h"
#include "runtime/cli/files/load_yaml.h"
#include "runtime/cli/files/output_path.h"
#include "runtime/text/json_dump.h"

namespace plsc::cli {

namespace {

struct HowToMutate {
  Encoding encoding = Encoding::kPlasticoding;
  MutationOptions options;
  double probability = Experiment{}.mutation;
};

// A genotype that senses nothing has no clauses to change.
Encoding EncodingOf(const Genotype& genotype) {
  return genotype.states.empty() ? Encoding::kBaseline
                                 : Encoding::kPlasticoding;
}

const char* VerbOf(MutationKind kind) {
  switch (kind) {
    case MutationKind::kDelete:
      return "deleted a symbol of";
    case MutationKind::kSwap:
      return "swapped two symbols of";
    case MutationKind::kAdd:
      return "added a symbol to";
    case MutationKind::kClause:
      break;
  }
  return "changed the clause of";
}

// Rules are told as those of the parent.
std::string RuleText(const Genotype& parent, const Mutation& mutation) {
  const Rule& one = parent.rules[mutation.rule];
  return fmt::format(
      "rule {} ({}{})", RuleNumber(mutation), parent.SymbolOf(one.head).name,
      one.clause.is_always() ? "" : " if " + PrintClause(one.clause, parent));
}

// As the evolver does it: the first number of the stream decides whether a
// child is mutated, which here it always is.
OneChild MutateOne(const Program& parent, const HowToMutate& how,
                   const StreamKey& key) {
  Rng rng(key);
  rng.Bernoulli(how.probability);
  const Mutation mutation =
      DrawMutation(parent.genotype, how.encoding, rng, how.options);
  OneChild child{parent, "", ""};
  child.program.tests.clear();
  child.program.genotype = Mutate(parent.genotype, mutation, rng, how.options);
  const bool has_changed = child.program.genotype != parent.genotype;
  const std::string rule = RuleText(parent.genotype, mutation);
  child.told = has_changed
                   ? fmt::format("{} {}", VerbOf(mutation.kind), rule)
                   : fmt::format("nothing changed: {} of {} had no effect",
                                 NameIn(kMutationNames, mutation.kind), rule);
  child.what = DumpJson(nlohmann::ordered_json{
      {"seed", std::to_string(key.seed)},
      {"generation", key.generation},
      {"individual", key.individual},
      {"mutation", NameIn(kMutationNames, mutation.kind)},
      {"rule", RuleNumber(mutation)},
      {"changed", has_changed}});
  return child;
}

// Whether the evolver's operators know the genotype. Prints why not.
bool CanVary(const Genotype& genotype, const std::string& path, Io& io) {
  const char* problem = nullptr;
  if (!genotype.alphabet->is_built_in())
    problem = "operators want the alphabet 'plasticoding 1', not a file's own";
  else if (genotype.rules.empty())
    problem = "at least one rule is expected, to be mutated";
  if (problem != nullptr)
    io.err << fmt::format("error: {}: {}\n", Escaped(path), problem);
  return problem == nullptr;
}

}  // namespace

Exit Run(const MutateCommand& command, Io& io) {
  const Output output{
      command.output,
      ChildrenKind(command.format),
      command.force,
      {SplitGenotypePath(command.file).file, command.experiment}};
  if (!CanWrite(output, io)) return Exit::kBadInput;
  const auto parent = LoadProgram(command.file, command.allow_range, io);
  if (!parent || !CanVary(parent->genotype, command.file, io))
    return Exit::kBadInput;
  HowToMutate how;
  how.encoding = EncodingOf(parent->genotype);
  if (!command.experiment.empty()) {
    const auto experiment = LoadExperiment(command.experiment, io);
    if (!experiment) return Exit::kBadInput;
    how = {experiment->genotype.encoding, experiment->variation,
           experiment->mutation};
  }
  std::vector<OneChild> children;
  children.reserve(static_cast<std::size_t>(command.count));
  for (int i = 0; i < command.count; ++i)
    children.push_back(
        MutateOne(*parent, how,
                  {command.stream.seed, command.stream.generation,
                   command.stream.individual + static_cast<std::uint64_t>(i),
                   Purpose::kMutate}));
  return DeliverChildren(std::move(children), output, io) ? Exit::kFine
                                                          : Exit::kBadInput;
}

}  // namespace plsc::cli
