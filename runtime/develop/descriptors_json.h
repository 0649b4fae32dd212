#pragma once

// Descriptors as a JSON object, for all writers of JSON.

#include <nlohmann/json.hpp>
#include <vector>

#include "runtime/develop/descriptors.h"

namespace plsc {

/// Counts are whole numbers in JSON too.
inline nlohmann::ordered_json DescriptorsJson(
    const std::vector<NamedValue>& values) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const NamedValue& value : values) {
    const std::string name(value.name);
    if (value.is_count)
      json[name] = static_cast<std::int64_t>(value.value);
    else
      json[name] = value.value;
  }
  return json;
}

}  // namespace plsc
