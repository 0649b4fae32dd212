#pragma once

// The symbols of the authors' program (Revolve at the commit that the paper
// cites): its tokens, its names in Python, its order of parameters. Shared by
// the readers and the writer of its genotypes.

#include <optional>
#include <string_view>
#include <vector>

#include "compiler/genotype.h"
#include "grammar/reporter.h"

namespace plsc {

struct AuthorsSymbol {
  SymbolId id{};
  std::string_view token;   ///< "AJ2"
  std::string_view python;  ///< "JOINT_VERTICAL"
};

/// Nothing for a word that is no token.
const AuthorsSymbol* FindAuthorsSymbol(std::string_view token);
const AuthorsSymbol& AuthorsSymbolOf(SymbolId symbol);

/// The letters, in the order in which Revolve writes them.
const std::vector<SymbolId>& AuthorsLetters();

/// A number of a text.
struct WrittenNumber {
  double value = 0;
  Span span;
};

/// A token and its parameters as they were read.
struct AuthorsWord {
  std::string_view token;
  Span span;
  std::vector<WrittenNumber> parameters;
};

/// Of every symbol A1 to T of joints the order is weight, period, phase,
/// amplitude there, and w, a, p, o here. Reports a token or a
/// parameter that cannot be; nothing then.
std::optional<Symbol> ImportSymbol(const AuthorsWord& word, bool allow_range,
                                   Reporter* reporter);

/// The parameters of `symbol` in the authors' order.
std::vector<double> AuthorsParameters(const Symbol& symbol);

}  // namespace plsc
