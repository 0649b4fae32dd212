#include "runtime/store/engine.h"

#include <fmt/format.h>

#include "sim/machine_kind.h"

namespace plsc {

std::string ThisEngine() {
  return fmt::format("{} {}", EngineId(), MachineKind());
}

}  // namespace plsc
