#pragma once

// A symbol of a string as JSON, for all writers of JSON.

#include <nlohmann/json.hpp>

#include "runtime/develop/regulate.h"

namespace plsc {

/// `["A2", [0.5, 2.0, 3.0, 1.0]]`.
inline nlohmann::ordered_json SymbolJson(const Genotype& genotype,
                                         const Occurrence& occurrence) {
  const SymbolInfo& info = genotype.SymbolOf(occurrence.symbol);
  auto arguments = nlohmann::ordered_json::array();
  if (occurrence.rule != kNoRule) {
    const Arguments& written = ArgumentsOf(genotype, occurrence);
    for (std::size_t i = 0; i < info.parameters.size(); ++i) {
      const double value = written[i];
      // Whole numbers beyond 2^53 keep their double form.
      if (info.parameters[i].is_integer && value < 9007199254740992.0)
        arguments.push_back(static_cast<std::int64_t>(value));
      else
        arguments.push_back(value);
    }
  }
  return nlohmann::ordered_json::array({info.name, std::move(arguments)});
}

}  // namespace plsc
