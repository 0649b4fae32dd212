#pragma once

// What a robot senses as a JSON object, for all writers of JSON: a state's
// value is true or false, a number, or the name of an enum's value, never the
// text of one of the first two.

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/genotype.h"

namespace plsc {

/// State -> value.
nlohmann::ordered_json EnvironmentJson(const Environment& environment,
                                       const std::vector<State>& states);

/// Of a value as a clause writes it ("True", "30.5", "wet"), of the state of
/// that name; the text itself if there is none such.
nlohmann::ordered_json SensedValueJson(const std::string& name,
                                       std::string_view value,
                                       const std::vector<State>& states);

/// State -> value, of what is inherited.
nlohmann::ordered_json SensesJson(
    const std::map<std::string, std::string>& senses,
    const std::vector<State>& states);

}  // namespace plsc
