#pragma once

// How what a genotype developed into differs from what its golden file
// expects, said in the words of modules, nodes, edges and symbols, so that a
// person sees what a change of the genotype did. Numbers are compared exactly
// but for descriptors.

#include <vector>

#include "runtime/compare/difference.h"
#include "runtime/compare/golden.h"

namespace plsc {

/// Empty exactly when both are equal (descriptors within `tolerance`, see
/// Golden; the order in which modules and nodes are listed does not count).
std::vector<Difference> Compare(const Observation& expected,
                                const Observation& found, double tolerance);

}  // namespace plsc
