#pragma once

// In which order a merge writes things that are known by what they are, not by
// where they stand: the items of a file, its genotypes. Either side may have
// moved some; what both added at one place comes in an order that does not
// depend on which side is ours.

#include <cstddef>
#include <string>
#include <vector>

namespace plsc {

/// Numbers of things as each version lists them. `ours` and `theirs` list only
/// things that stay.
struct OrderVersions {
  std::vector<std::size_t> base;
  std::vector<std::size_t> ours;
  std::vector<std::size_t> theirs;
};

/// All of `ours` and `theirs`. `names` by number: the order of what both sides
/// added at one place.
std::vector<std::size_t> MergeOrder(const OrderVersions& versions,
                                    const std::vector<std::string>& names);

}  // namespace plsc
