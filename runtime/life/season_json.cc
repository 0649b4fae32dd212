#include "runtime/life/season_json.h"

#include <fmt/format.h>

#include "runtime/develop/descriptors_json.h"
#include "runtime/develop/environment_json.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

Json BehaviourJson(const Behaviour& behaviour) {
  if (!behaviour.is_valid) return nullptr;
  return DescriptorsJson(List(behaviour));
}

Json SensedJson(const std::vector<SensedState>& sensed,
                const std::vector<State>& states) {
  Json json = Json::object();
  for (const SensedState& state : sensed)
    json[state.name] = {
        {"value", SensedValueJson(state.name, state.value, states)},
        {"from", NameIn(kSenseSourceNames, state.from)}};
  return json;
}

}  // namespace

std::string SeasonJson(const Genotype& genotype, const SeasonResult& result) {
  Json json;
  json["genotype"] = genotype.name;
  json["season"] = result.season;
  json["profile"] = NameIn(kProfileNames, result.profile);
  json["begin"] = result.begin;
  json["sensed"] = SensedJson(result.sensed, genotype.states);
  json["inclination"] =
      result.inclination ? Json(*result.inclination) : Json(nullptr);
  json["change"] = NameIn(kChangeNames, result.change);
  json["change_reason"] = result.change_reason;
  json["outcome"] = OutcomeName(result.outcome);
  json["reason"] = result.reason;
  json["fitness"] = result.fitness ? Json(*result.fitness) : Json(nullptr);
  json["behaviour"] = BehaviourJson(result.behaviour);
  // A body has a core at least; zeros would pass for a robot's.
  const bool has_robot = result.body.absolute_size > 0;
  json["body_descriptors"] =
      has_robot ? DescriptorsJson(List(result.body)) : Json(nullptr);
  json["brain_descriptors"] =
      has_robot ? DescriptorsJson(List(result.brain)) : Json(nullptr);
  json["steps"] = result.steps;
  json["solver_warnings"] = result.solver_warnings;
  json["state_hash"] = fmt::format("{:016x}", result.state_hash);
  return json.dump();
}

std::string EvaluationJson(const Genotype& genotype,
                           const Evaluation& evaluation) {
  Json fitness = Json::object();
  std::string seasons;
  for (const SeasonResult& season : evaluation.seasons) {
    fitness[season.season] =
        season.fitness ? Json(*season.fitness) : Json(nullptr);
    if (!seasons.empty()) seasons += ',';
    seasons += SeasonJson(genotype, season);
  }
  return fmt::format(R"("fitness":{},"seasons":[{}])", fitness.dump(), seasons);
}

}  // namespace plsc
