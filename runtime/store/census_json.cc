#include "runtime/store/census_json.h"

#include <nlohmann/json.hpp>

#include "runtime/store/schema.h"

namespace plsc {

nlohmann::ordered_json CensusJson(const CensusCounts& counts) {
  const auto names = CensusColumns();
  const auto values = List(counts);
  nlohmann::ordered_json json;
  for (std::size_t i = 0; i < values.size(); ++i) json[names[i]] = values[i];
  return json;
}

}  // namespace plsc
