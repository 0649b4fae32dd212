#pragma once

// What the simulator told as bytes, for the way from a worker to the run and
// into a shared cache: every double bit for bit. The layout is spelled out,
// because machines of a cluster and versions of a cache read each other's.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/life/simulated.h"

namespace plsc {

std::string PackSimulated(const std::vector<Simulated>& seasons);
/// Nothing when the bytes are not a whole one.
std::optional<std::vector<Simulated>> UnpackSimulated(std::string_view bytes);

}  // namespace plsc
