#pragma once

// The part of runtime/compare/golden_compare that looks at bodies and brains:
// finds which module of one robot is which of the other, and from that which
// node and edge, so that a module mounted early does not make all later ones
// look changed though their numbers have moved on.

#include <vector>

#include "runtime/compare/difference.h"
#include "runtime/compare/golden.h"

namespace plsc {

/// Appends to `differences`. A module is the same where it sits in the same
/// place, or has moved and kept number and type; nodes and edges go with their
/// modules, and those of an added or missing module are not reported again.
void CompareParts(const GoldenRobot& expected, const GoldenRobot& found,
                  std::vector<Difference>& differences);

}  // namespace plsc
