#include "sim/body.h"

namespace plsc {

std::string ModuleId(const Body& body, int index) {
  const Module& module = body.modules[static_cast<std::size_t>(index)];
  if (module.type != ModuleType::kTouchSensor)
    return std::to_string(module.number);
  // Sensors sit only on cores and bricks, so this recurses once.
  return ModuleId(body, module.parent) + "s" +
         std::to_string(static_cast<int>(module.slot));
}

}  // namespace plsc
