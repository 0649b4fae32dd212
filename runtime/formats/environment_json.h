#pragma once

// What a robot senses as a JSON object, for the writers of this folder.

#include <nlohmann/json.hpp>
#include <vector>

#include "compiler/genotype.h"

namespace plsc {

/// State -> true or false, a number, or the name of an enum's value.
inline nlohmann::ordered_json EnvironmentJson(
    const Environment& environment, const std::vector<State>& states) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < states.size(); ++i) {
    const State& state = states[i];
    const double value = environment.values[i];
    if (state.type == StateType::kBool)
      json[state.name] = value != 0;
    else if (state.type == StateType::kEnum)
      json[state.name] = state.values[static_cast<std::size_t>(value)];
    else
      json[state.name] = value;
  }
  return json;
}

}  // namespace plsc
