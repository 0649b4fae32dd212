#pragma once

// One thing in which a robot is not what was expected, in words for people.

#include <cstdint>
#include <string>
#include <string_view>

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

}  // namespace plsc
