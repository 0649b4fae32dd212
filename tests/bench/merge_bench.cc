// How often two independent mutations of one genotype conflict when they are
// merged, and whether what merges is both. Reports; asserts nothing.
//   merge_bench [--smoke]

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <string>
#include <string_view>

#include "compiler/changes/merge_program.h"
#include "compiler/compile.h"
#include "compiler/print.h"
#include "tests/runtime/merge/mutation_pair.h"

namespace {

using plsc::kMutationNames;
using plsc::NameIn;
using plsc::Print;
using plsc::Source;

struct Counts {
  int pairs = 0;
  int conflicts = 0;
  int same_place = 0;  // the mutations touch the same
  int avoidable = 0;   // conflicts of others
  int wrong = 0;       // clean, but not both
  int undecided = 0;   // clean where both cannot be told
  int same_rule = 0;
};

void Count(std::uint64_t number, Counts& counts) {
  const auto pair = plsc::test::DrawMutationPair(number);
  const auto merged = plsc::MergeFiles(Source("base", Print(pair.base)),
                                       Source("ours", Print(pair.ours)),
                                       Source("theirs", Print(pair.theirs)));
  ++counts.pairs;
  counts.same_rule += pair.our_mutation.rule == pair.their_mutation.rule;
  counts.same_place += !pair.composed;
  if (!merged.conflicts.empty()) {
    ++counts.conflicts;
    counts.avoidable += pair.composed.has_value();
    if (counts.conflicts <= 10)
      fmt::print("  {} {}+{}{} {}\n", number,
                 NameIn(kMutationNames, pair.our_mutation.kind),
                 NameIn(kMutationNames, pair.their_mutation.kind),
                 pair.composed ? " avoidable" : "",
                 merged.conflicts.front().message);
    return;
  }
  if (!pair.composed) {
    ++counts.undecided;
    fmt::print("{}: clean, though both touch the same ({}+{})\n", number,
               NameIn(kMutationNames, pair.our_mutation.kind),
               NameIn(kMutationNames, pair.their_mutation.kind));
    return;
  }
  const auto program = plsc::Compile(Source("merged", merged.text));
  const bool is_right = program && program->genotype == *pair.composed &&
                        merged.text == Print(*pair.composed);
  if (!is_right) {
    ++counts.wrong;
    fmt::print("{}: not the composition ({}+{})\n", number,
               NameIn(kMutationNames, pair.our_mutation.kind),
               NameIn(kMutationNames, pair.their_mutation.kind));
  }
}

}  // namespace

int main(int argc, char** argv) {
  const bool is_smoke = argc > 1 && std::string_view(argv[1]) == "--smoke";
  const int pairs = is_smoke ? 100 : 20000;
  Counts counts;
  for (int i = 0; i < pairs; ++i) Count(static_cast<std::uint64_t>(i), counts);
  fmt::print(
      "{} pairs: {} conflicts ({:.2f} %); {} touch the same place, {} the same "
      "rule;\n{} conflicts that could be avoided, {} wrong, {} undecided\n",
      counts.pairs, counts.conflicts, 100.0 * counts.conflicts / counts.pairs,
      counts.same_place, counts.same_rule, counts.avoidable, counts.wrong,
      counts.undecided);
  return 0;
}
