#include "runtime/store/engine.h"

#include <fmt/format.h>

#include "runtime/store/versions.h"
#include "sim/machine_kind.h"

namespace plsc {

std::string ThisEngine(bool uses_ode) {
  if (!uses_ode) return fmt::format("{} {}", EngineId(), kAnyMachine);
  return fmt::format("{} {}", EngineId(), MachineKind());
}

}  // namespace plsc
