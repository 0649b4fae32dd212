#pragma once

// Reads tests/data/geometry.json: bodies as the authors' program developed and
// assembled them, against which modules, assembly and overlap are checked.

#include <cstddef>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/sim/bodies.h"

namespace plsc {

inline nlohmann::json LoadAuthorsBodies() {
  std::ifstream file(std::string(PLSC_SOURCE_DIR) +
                     "/tests/data/geometry.json");
  return nlohmann::json::parse(file).at("cases");
}

/// The file does not tell the two joints apart; their accumulated roll does.
inline ModuleType TypeOf(const std::string& name, int roll) {
  static const std::map<std::string, ModuleType> types = {
      {"CoreComponent", ModuleType::kCore},
      {"FixedBrick", ModuleType::kBrick},
      {"TouchSensor", ModuleType::kTouchSensor}};
  if (name != "ActiveHinge") return types.at(name);
  return roll % 180 == 0 ? ModuleType::kHorizontalJoint
                         : ModuleType::kVerticalJoint;
}

/// Adds a module and all it carries, as the file lists them.
inline void AddFromJson(const nlohmann::json& module, int parent, int roll,
                        Body& body) {
  const int angle = module.at("angle").get<int>();
  const ModuleType type =
      TypeOf(module.at("type").get<std::string>(), roll + angle);
  int index = 0;
  if (parent == kNoModule) {
    body = LoneCore();
  } else {
    index = Mount(body, parent, static_cast<Slot>(module.at("slot").get<int>()),
                  type);
    // The file's own, not the helper's rule.
    body.modules[static_cast<std::size_t>(index)].angle_deg = angle;
  }
  if (!module.contains("children")) return;
  for (const auto& child : module.at("children"))
    AddFromJson(child, index, roll + angle, body);
}

inline Body BodyFromJson(const nlohmann::json& core) {
  Body body;
  AddFromJson(core, kNoModule, 0, body);
  return body;
}

/// Sides taken from the core to the module, as the authors' names have them:
/// "" for the core, "N" for what sits on its front, "NE"...
inline std::string Chain(const Body& body, int index) {
  const Module& module = body.modules[static_cast<std::size_t>(index)];
  if (module.parent == kNoModule) return "";
  return Chain(body, module.parent) + "SNEW"[static_cast<int>(module.slot)];
}

}  // namespace plsc
