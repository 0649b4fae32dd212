#pragma once

// From the text of a file to JSON values: the first step of every reader of
// ours, the same errors for all of them.

#include <nlohmann/json.hpp>

#include "grammar/result.h"
#include "grammar/source.h"

namespace plsc {

/// Refuses what is no UTF-8 text, empty, no JSON, or has a key twice in an
/// object.
Result<nlohmann::json> ReadJson(const Source& source);

}  // namespace plsc
