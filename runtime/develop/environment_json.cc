#include "runtime/develop/environment_json.h"

#include <algorithm>

#include "compiler/environment_text.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

Json ValueJson(double value, const State& state) {
  switch (state.type) {
    case StateType::kBool:
      return value != 0;
    case StateType::kEnum:
      return state.values[static_cast<std::size_t>(value)];
    case StateType::kReal:
      break;
  }
  return value;
}

}  // namespace

Json EnvironmentJson(const Environment& environment,
                     const std::vector<State>& states) {
  Json json = Json::object();
  for (std::size_t i = 0; i < states.size(); ++i)
    json[states[i].name] = ValueJson(environment.values[i], states[i]);
  return json;
}

Json SensedValueJson(const std::string& name, std::string_view value,
                     const std::vector<State>& states) {
  const auto state =
      std::find_if(states.begin(), states.end(),
                   [&](const State& one) { return one.name == name; });
  if (state != states.end())
    if (const auto number = ParseStateValue(value, *state))
      return ValueJson(*number, *state);
  return value;
}

Json SensesJson(const std::map<std::string, std::string>& senses,
                const std::vector<State>& states) {
  Json json = Json::object();
  for (const auto& [name, value] : senses)
    json[name] = SensedValueJson(name, value, states);
  return json;
}

}  // namespace plsc
