#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>

#include "compiler/verify.h"
#include "grammar/shown_line.h"
#include "runtime/cli/arguments/genotypes.h"
#include "runtime/cli/commands/offspring.h"
#include "runtime/cli/files/load_program.h"
#include "runtime/cli/files/load_yaml.h"
#include "runtime/cli/files/output_path.h"
#include "runtime/text/json_dump.h"
#include "runtime/vary/crossover.h"

namespace plsc::cli {

namespace {

// Why the two cannot be parents of one child; nothing when they can.
const char* WhyNot(const Genotype& first, const Genotype& second) {
  if (!(*first.alphabet == *second.alphabet))
    return "parents with equal alphabets are expected";
  if (first.states != second.states)
    return "parents that sense the same states, declared in the same order, "
           "are expected";
  return nullptr;
}

// As the evolver does it: the first number of the stream decides whether there
// is a crossover, which here there always is.
OneChild CrossOne(const Program& first, const Genotype& second,
                  double probability, const StreamKey& key) {
  Rng rng(key);
  rng.Bernoulli(probability);
  const Alphabet& alphabet = *first.genotype.alphabet;
  const std::vector<bool> choices = DrawCrossover(alphabet, rng);
  OneChild child{first, "", ""};
  child.program.tests.clear();
  child.program.genotype = Cross(first.genotype, second, choices);
  child.program.genotype.name = first.genotype.name;
  std::vector<std::string> from_second;
  std::size_t choice = 0;
  for (const SymbolInfo& symbol : alphabet.symbols())
    if (symbol.is_replaceable && choices[choice++])
      from_second.push_back(symbol.name);
  child.told = from_second.empty()
                   ? "no rules of the second parent"
                   : fmt::format("rules of {} from the second parent",
                                 fmt::join(from_second, ", "));
  child.what =
      DumpJson(nlohmann::ordered_json{{"seed", std::to_string(key.seed)},
                                      {"generation", key.generation},
                                      {"individual", key.individual},
                                      {"from_second", from_second}});
  return child;
}

}  // namespace

Exit Run(const CrossCommand& command, Io& io) {
  const Output output{
      command.output,
      ChildrenKind(command.format),
      command.force,
      {SplitGenotypePath(command.first).file,
       SplitGenotypePath(command.second).file, command.experiment}};
  if (!CanWrite(output, io)) return Exit::kBadInput;
  const auto first = LoadProgram(command.first, command.allow_range, io);
  const auto second = LoadProgram(command.second, command.allow_range, io);
  if (!first || !second) return Exit::kBadInput;
  if (const char* problem = WhyNot(first->genotype, second->genotype)) {
    io.err << fmt::format("error: {} and {}: {}\n", Escaped(command.first),
                          Escaped(command.second), problem);
    return Exit::kBadInput;
  }
  double probability = Experiment{}.crossover;
  if (!command.experiment.empty()) {
    const auto experiment = LoadExperiment(command.experiment, io);
    if (!experiment) return Exit::kBadInput;
    probability = experiment->crossover;
  }
  std::vector<OneChild> children;
  children.reserve(static_cast<std::size_t>(command.count));
  for (int i = 0; i < command.count; ++i) {
    children.push_back(
        CrossOne(*first, second->genotype, probability,
                 {command.stream.seed, command.stream.generation,
                  command.stream.individual + static_cast<std::uint64_t>(i),
                  Purpose::kCrossover}));
    // The limits are the first parent's, the rules perhaps not.
    const auto broken = Verify(children.back().program.genotype);
    if (broken.empty()) continue;
    io.err << fmt::format("error: a child of {} and {}: {}\n",
                          Escaped(command.first), Escaped(command.second),
                          broken.front());
    return Exit::kBadInput;
  }
  return DeliverChildren(std::move(children), output, io) ? Exit::kFine
                                                          : Exit::kBadInput;
}

}  // namespace plsc::cli
