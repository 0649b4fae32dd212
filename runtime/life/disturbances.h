#pragma once

// Disturbances of a whole life, and their text, which is exact: part of the
// keys of what is disturbed (runtime/life/life_plan) and of what workers are
// asked for.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sim/disturbance.h"

namespace plsc {

/// By season; empty: none is disturbed.
using Disturbances = std::vector<Disturbance>;

Disturbance DisturbanceIn(const Disturbances& disturbances, std::size_t season);

/// One line, with its end; nothing of a season that is not disturbed.
std::string DisturbanceText(const Disturbance& disturbance);

/// Of a text that DisturbanceText wrote, with the line's end or without.
Disturbance ReadDisturbance(std::string_view text);

}  // namespace plsc
