#pragma once

// The invariants of a Genotype, whoever made it: the compiler, the evolver or
// a test. Printing and developing rely on them.

#include <string>
#include <vector>

#include "compiler/program.h"

namespace plsc {

/// One sentence a broken invariant; empty when all hold.
std::vector<std::string> Verify(const Genotype& genotype);
std::vector<std::string> Verify(const Program& program);

}  // namespace plsc
