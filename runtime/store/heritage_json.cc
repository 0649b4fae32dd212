#include "runtime/store/heritage_json.h"

#include "runtime/develop/environment_json.h"

namespace plsc {

nlohmann::ordered_json HeritageJson(const Heritage& heritage,
                                    const Alphabet& alphabet,
                                    const std::vector<State>& states) {
  nlohmann::ordered_json json;
  json["parents"] = heritage.parents;
  json["from_second"] = nlohmann::ordered_json::array();
  for (const SymbolId head : heritage.from_second)
    json["from_second"].push_back(alphabet[head].name);
  json["mutation"] = nullptr;
  json["mutated_rule"] = nullptr;
  if (heritage.mutation) {
    json["mutation"] = NameIn(kMutationNames, heritage.mutation->kind);
    json["mutated_rule"] = RuleNumber(*heritage.mutation);
  }
  json["senses"] = SensesJson(heritage.senses, states);
  return json;
}

}  // namespace plsc
