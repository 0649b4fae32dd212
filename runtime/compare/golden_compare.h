#pragma once

// How what a genotype developed into differs from what its golden file
// expects, said in the words of modules, nodes, edges and symbols, so that a
// person sees what a change of the genotype did. Numbers are compared exactly
// but for descriptors.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/compare/golden.h"

namespace plsc {

enum class DifferenceKind : std::uint8_t {
  kAdded,
  kMissing,
  kMoved,
  kChanged,
};

struct Difference {
  DifferenceKind kind = DifferenceKind::kChanged;
  std::string what;      ///< "weight of edge node3->node1"
  std::string expected;  ///< kMoved and kChanged only, as the next
  std::string found;

  friend bool operator==(const Difference&, const Difference&) = default;
};

/// "added", "missing", "moved", "changed".
std::string_view KindName(DifferenceKind kind);

/// "weight of edge node3->node1: expected 0.5, found 0.25".
std::string Describe(const Difference& difference);

/// Empty exactly when both are equal (descriptors within `tolerance`, see
/// Golden; the order in which modules and nodes are listed does not count).
std::vector<Difference> Compare(const Observation& expected,
                                const Observation& found, double tolerance);

}  // namespace plsc
