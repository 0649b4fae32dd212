// How fast symbol strings are rewritten, beside L-Py. Reports; asserts nothing.
//
//   derive_bench [--smoke]
//
// A symbol counts as written each time that a rewriting puts it into a string,
// also when it only stays; the axiom is not written. "Final" counts the last
// string alone and so is the smaller figure. Both are over the processor time
// of the whole derivation. L-Py's range was measured with L-Py 3.15 on
// grammars without parameters or conditions (7.7) to ones with them (0.8).

#include <fmt/format.h>

#include <cstring>

#include "compiler/compile.h"
#include "runtime/develop/derive.h"
#include "tests/bench/stopwatch.h"

namespace plsc {
namespace {

struct Grammar {
  const char* name;
  const char* rest;  ///< its rules over X, Y, Z and a
};

constexpr Grammar kGrammars[] = {
    {"didactic (the paper's)",
     "rule X -> { X Y }\nrule Y -> { Z a }\nrule Z -> { X Z }\n"},
    {"algae (Lindenmayer's)", "rule X -> { X Y }\nrule Y -> { X }\n"},
    {"koch (nine symbols for one)", "rule X -> { X a X a X a X a X }\n"},
};

Genotype CompileGrammar(const Grammar& grammar) {
  const Source source("grammar",
                      fmt::format("plsc 1\ngenotype bench\n"
                                  "alphabet abc {{ replaceable X, Y, Z; "
                                  "terminal a }}\naxiom X\n{}",
                                  grammar.rest));
  return Compile(source)->genotype;
}

void Measure(const Grammar& grammar, std::size_t most, double seconds) {
  Genotype genotype = CompileGrammar(grammar);
  const ActiveRules active = Regulate(genotype, {});
  // As many rewritings as keep the string within `most` symbols.
  genotype.development.iterations = 0;
  std::size_t written = 0;
  std::size_t length = 1;
  while (true) {
    ++genotype.development.iterations;
    const std::optional<SymbolString> string = Derive(genotype, active);
    if (!string || string->size() > most) break;
    length = string->size();
    written += length;
  }
  --genotype.development.iterations;
  const double each = bench::SecondsEach(seconds, [&] {
    return static_cast<double>(Derive(genotype, active)->back().position);
  });
  fmt::print("{:<28} {:>3} {:>9} {:>10.0f} {:>8.0f}\n", grammar.name,
             genotype.development.iterations, length,
             1e-6 * static_cast<double>(written) / each,
             1e-6 * static_cast<double>(length) / each);
}

}  // namespace
}  // namespace plsc

int main(int argc, char** argv) {
  const bool smoke = argc > 1 && std::strcmp(argv[1], "--smoke") == 0;
  fmt::print("million symbols a second; L-Py: 0.8 to 7.7\n");
  fmt::print("{:<28} {:>3} {:>9} {:>10} {:>8}\n", "grammar", "k", "length",
             "written", "final");
  for (const plsc::Grammar& grammar : plsc::kGrammars)
    // As long as strings may be, and as short as evolved robots have them.
    for (const std::size_t most : {plsc::kMaxStringLength, std::size_t{300}})
      plsc::Measure(grammar, most, smoke ? 0 : 1);
  return 0;
}
