#pragma once

// How the body of one environment differs from that of another: modules are
// the same ones when they sit at the same place of the tree, the way of slots
// that leads there from the core.

#include <cstdint>
#include <string>
#include <vector>

#include "sim/body.h"

namespace plsc {

enum class ModuleMark : std::uint8_t {
  kShared,  ///< the reference has the same module there
  kOther,   ///< it has one of another kind or roll there
  kNew,     ///< it has none there
};

struct BodyDifference {
  std::vector<ModuleMark> marks;  ///< by module of the body
  std::vector<int> missing;  ///< modules of the reference whose place is empty
};

BodyDifference CompareBodies(const Body& reference, const Body& body);

/// The place of each module: "" the core, else a digit of Slot a step.
std::vector<std::string> PlacesOf(const Body& body);

}  // namespace plsc
