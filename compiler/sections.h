#pragma once

// A file of several genotypes. From `genotype NAME` to the next one is a
// section; what stands before the first belongs to all of them, as if it were
// written in each. A file that names one genotype, or none, is one section,
// wherever the name stands.

#include <vector>

#include "grammar/ast.h"

namespace plsc {

/// A File a genotype, with all that belongs to it. Of files that name two or
/// more. Comments stay behind (suppressions look at the whole file).
std::vector<ast::File> SplitIntoSections(const ast::File& file);

}  // namespace plsc
