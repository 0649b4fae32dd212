#pragma once

// `alphabet NAME { replaceable X; terminal a(t: int in 0..5) }`: a file's own
// vocabulary, for grammars other than Plasticoding.

#include <vector>

#include "compiler/alphabet.h"
#include "grammar/ast.h"
#include "grammar/diagnostic.h"

namespace plsc {

struct OwnAlphabet {
  AlphabetPtr alphabet;  ///< of the declarations that are right; never null
  std::vector<Diagnostic> diagnostics;
};

OwnAlphabet DeclareAlphabet(const ast::File& file,
                            const ast::Alphabet& declared);

/// How values of a parameter of a file's own alphabet are drawn: uniformly
/// from its range, else as Table 1 draws those without a range.
Sampling DefaultSampling(const Parameter& parameter);

}  // namespace plsc
