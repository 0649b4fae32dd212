// Canonical text as much as output: keys of phenotypes are hashes of it, stores
// keep it, and packing knows its phrases. Keys are in a fixed order, numbers
// read back to the same double, and children come in the order front, left,
// right, back. What changes here changes keys and makes old stores unreadable.

#include "runtime/develop/phenotype_json.h"

#include <nlohmann/json.hpp>

#include "runtime/develop/descriptors_json.h"
#include "runtime/develop/environment_json.h"
#include "runtime/develop/part_names.h"
#include "runtime/develop/regulate.h"
#include "runtime/develop/symbol_json.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

// Recursion is as deep as the body, at most max_modules.
Json ModuleJson(const Body& body, int index) {
  const Module& module = body.modules[static_cast<std::size_t>(index)];
  const bool is_sensor = module.type == ModuleType::kTouchSensor;
  Json json;
  json["id"] = ModuleId(body, index);
  json["type"] = ModuleName(module.type);
  json["angle"] = module.angle_deg;
  json["x"] = is_sensor ? Json(nullptr) : Json(module.x);
  json["y"] = is_sensor ? Json(nullptr) : Json(module.y);
  json["facing"] = is_sensor ? Json(nullptr) : Json(FacingName(module.facing));
  Json children = Json::object();
  for (const Slot slot : {Slot::kFront, Slot::kLeft, Slot::kRight, Slot::kBack})
    if (module.child(slot) != kNoModule)
      children[std::string(SlotName(slot))] =
          ModuleJson(body, module.child(slot));
  json["children"] = std::move(children);
  return json;
}

Json BrainOf(const Phenotype& phenotype) {
  Json nodes = Json::array();
  for (std::size_t i = 0; i < phenotype.brain.nodes.size(); ++i) {
    const Node& node = phenotype.brain.nodes[i];
    const bool is_input = node.type == NodeType::kInput;
    Json json;
    json["id"] = NodeName(static_cast<int>(i));
    json["type"] = is_input ? "Input" : "Oscillator";
    json["part"] = ModuleId(phenotype.body, node.module);
    json["weight"] = node.weight;
    if (!is_input) {
      json["amplitude"] = node.amplitude;
      json["period"] = node.period;
      json["phase_offset"] = node.phase_offset;
    }
    nodes.push_back(std::move(json));
  }
  Json connections = Json::array();
  for (const Connection& connection : phenotype.brain.connections)
    connections.push_back({{"src", NodeName(connection.source)},
                           {"dst", NodeName(connection.destination)},
                           {"weight", connection.weight}});
  return {{"nodes", std::move(nodes)},
          {"imu_inputs", kImuInputs},
          {"connections", std::move(connections)}};
}

}  // namespace

std::string BodyJson(const Body& body) {
  return ModuleJson(body, 0).dump();
}

std::string BrainJson(const Phenotype& phenotype) {
  return BrainOf(phenotype).dump();
}

std::string DevelopmentJson(const Genotype& genotype,
                            const Environment& environment,
                            const SymbolString& string,
                            const Phenotype* phenotype) {
  Json json;
  json["genotype"] = genotype.name;
  json["environment"] = EnvironmentJson(environment, genotype.states);
  Json active = Json::array();
  for (const RuleIndex rule : Regulate(genotype, environment).rules)
    active.push_back(rule + 1);
  json["active_rules"] = std::move(active);
  Json early = Json::array();
  for (const Occurrence& occurrence : string)
    early.push_back(SymbolJson(genotype, occurrence));
  json["early"] = std::move(early);
  if (phenotype != nullptr) {
    json["body"] = ModuleJson(phenotype->body, 0);
    json["brain"] = BrainOf(*phenotype);
    json["body_descriptors"] =
        DescriptorsJson(List(DescribeBody(phenotype->body)));
    json["brain_descriptors"] =
        DescriptorsJson(List(DescribeBrain(*phenotype)));
  }
  return json.dump();
}

}  // namespace plsc
