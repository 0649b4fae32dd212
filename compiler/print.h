#pragma once

// From IR to canonical text: header items in fixed order, rules grouped in
// alphabet order, one symbol a line, every number the shortest text that reads
// back to the same double. Compile(Print(p)) == p, bit for bit.

#include <string>

#include "compiler/program.h"

namespace plsc {

std::string Print(const Program& program);
std::string Print(const Genotype& genotype);

/// Parts of it, for messages: `inclined = True and hot = False`,
/// `A1(0.5, 1.0, 2.0, 3.0)`.
std::string PrintClause(const Clause& clause, const Genotype& genotype);
std::string PrintSymbol(const Symbol& symbol, const Alphabet& alphabet);
/// `C { front B }`: the body of an inline test on one line.
std::string PrintBody(const std::vector<ExpectedModule>& body,
                      const Alphabet& alphabet);
/// `alphabet plasticoding 1`, or a file's own with one group of symbols a
/// line. Ends in a newline.
std::string PrintAlphabet(const Alphabet& alphabet);
/// `inclined=True,hot=False`: the form of `--env`.
std::string PrintEnvironment(const Environment& environment,
                             const std::vector<State>& states);

}  // namespace plsc
