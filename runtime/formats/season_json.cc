#include "runtime/formats/season_json.h"

#include <fmt/format.h>

#include "runtime/formats/descriptors_json.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

Json BehaviourJson(const Behaviour& behaviour) {
  if (!behaviour.is_valid) return nullptr;
  return DescriptorsJson(List(behaviour));
}

}  // namespace

std::string SeasonJson(const std::string& genotype,
                       const SeasonResult& result) {
  Json json;
  json["genotype"] = genotype;
  json["season"] = result.season;
  json["outcome"] = OutcomeName(result.outcome);
  json["fitness"] = result.fitness ? Json(*result.fitness) : Json(nullptr);
  json["behaviour"] = BehaviourJson(result.behaviour);
  json["body_descriptors"] = DescriptorsJson(List(result.body));
  json["brain_descriptors"] = DescriptorsJson(List(result.brain));
  json["state_hash"] = fmt::format("{:016x}", result.state_hash);
  return json.dump();
}

}  // namespace plsc
