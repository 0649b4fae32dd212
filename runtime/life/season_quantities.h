#pragma once

// What formulas may ask about a season (runtime/formula/quantities), of one
// result.

#include <vector>

#include "runtime/life/season_result.h"

namespace plsc {

/// By quantity, of a season that was lived to its end.
std::vector<double> QuantitiesOf(const SeasonResult& result,
                                 const Season& season);

}  // namespace plsc
