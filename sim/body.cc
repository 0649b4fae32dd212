#include "sim/body.h"

#include <array>
#include <cassert>

namespace plsc {

Facing FacingOf(Facing facing, Slot slot) {
  // Counter-clockwise quarter turns from the front.
  constexpr std::array<int, kSlots> kTurns{2, 0, 3, 1};  // by Slot
  return static_cast<Facing>(
      (static_cast<int>(facing) + kTurns[static_cast<std::size_t>(slot)]) % 4);
}

Facing Opposite(Facing facing) {
  return static_cast<Facing>((static_cast<int>(facing) + 2) % 4);
}

std::string_view ModuleName(ModuleType type) {
  for (const auto& [one, name] : kModuleNames)
    if (one == type) return name;
  assert(false);
  return "";
}

std::string ModuleId(const Body& body, int index) {
  const Module& module = body.modules[static_cast<std::size_t>(index)];
  if (module.type != ModuleType::kTouchSensor)
    return std::to_string(module.number);
  // Sensors sit only on cores and bricks, so this recurses once.
  return ModuleId(body, module.parent) + "s" +
         std::to_string(static_cast<int>(module.slot));
}

}  // namespace plsc
