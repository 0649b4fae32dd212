#pragma once

// What Lint says of a document, genotype by genotype: to develop all of a
// collection may take seconds, and the next keystroke must not wait for it.

#include <cstddef>
#include <vector>

#include "runtime/lsp/analysis.h"

namespace plsc::lsp {

struct Advice {
  std::vector<Diagnostic> found;  ///< sorted and silenced once it is whole
  std::size_t linted = 0;         ///< genotypes
  bool is_whole = false;
};

/// Looks at the next genotype of a document, if it compiles; a broken one is
/// soon another.
void GiveMoreAdvice(Analysis& analysis, Advice* advice);

}  // namespace plsc::lsp
