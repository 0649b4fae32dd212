#include "runtime/history/regulation_json.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "runtime/develop/environment_json.h"
#include "runtime/develop/regulate.h"
#include "runtime/develop/symbol_json.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

Json NumbersJson(const std::vector<RuleIndex>& rules) {
  Json numbers = Json::array();
  for (const RuleIndex rule : rules) numbers.push_back(rule + 1);
  return numbers;
}

Json ClassJson(const ValueClass& values, const State& state) {
  if (state.type == StateType::kReal)
    return {{"low", values.low},
            {"high", values.high},
            {"has_low", values.has_low},
            {"has_high", values.has_high}};
  Json list = Json::array();
  for (const int value : values.named) {
    if (state.type == StateType::kBool)
      list.push_back(value != 0);
    else
      list.push_back(state.values[static_cast<std::size_t>(value)]);
  }
  return list;
}

}  // namespace

std::string RegulationJson(const Genotype& genotype,
                           const NamedEnvironment& named) {
  const ActiveRules active = Regulate(genotype, named.environment);
  Json json;
  json["genotype"] = genotype.name;
  json["environment"] = EnvironmentJson(named.environment, genotype.states);
  json["active_rules"] = NumbersJson(active.rules);
  json["symbols"] = Json::object();
  for (const SymbolRules& symbol : BySymbol(genotype, active)) {
    Json entry;
    entry["rules"] = NumbersJson(symbol.active);
    if (!symbol.active.empty()) entry["joined"] = Json::array();
    for (const Occurrence& occurrence : active.joined[symbol.symbol])
      entry["joined"].push_back(SymbolJson(genotype, occurrence));
    json["symbols"][genotype.SymbolOf(symbol.symbol).name] = std::move(entry);
  }
  return json.dump();
}

std::string RegulationRowJson(const Genotype& genotype, const StateSpace& space,
                              int index) {
  const Environment environment{space.At(index)};
  const ActiveRules active = Regulate(genotype, environment);
  Json json;
  json["genotype"] = genotype.name;
  json["when"] = Json::object();
  for (std::size_t i = 0; i < space.states().size(); ++i) {
    const State& state = genotype.StateOf(space.states()[i]);
    json["when"][state.name] =
        ClassJson(space.classes(i)[space.ClassAt(index, i)], state);
  }
  json["environment"] = EnvironmentJson(environment, genotype.states);
  json["active_rules"] = NumbersJson(active.rules);
  json["symbols"] = Json::object();
  for (const SymbolRules& symbol : BySymbol(genotype, active))
    json["symbols"][genotype.SymbolOf(symbol.symbol).name] =
        NumbersJson(symbol.active);
  return json.dump();
}

}  // namespace plsc
