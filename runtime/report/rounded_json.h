#pragma once

// Numbers of a report's JSON, with six digits: more than any figure shows, and
// half the size.

#include <cmath>
#include <nlohmann/json.hpp>

#include "grammar/number.h"

namespace plsc {

/// Null for what is no number.
inline nlohmann::ordered_json RoundedNumber(double value) {
  if (!std::isfinite(value)) return nullptr;
  return *ParseNumber<double>(PrintRoundedNumber(value, 6));
}

}  // namespace plsc
