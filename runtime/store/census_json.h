#pragma once

// A census as JSON, under the names of the store's columns.

#include <nlohmann/json_fwd.hpp>

#include "runtime/store/census.h"

namespace plsc {

nlohmann::ordered_json CensusJson(const CensusCounts& counts);

}  // namespace plsc
