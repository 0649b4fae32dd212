// Instead of sim/ode, where it is not built (PLSC_ODE is OFF).

#include <cassert>

#include "sim/engine.h"
#include "sim/options.h"

namespace plsc {

bool HasOde() {
  return false;
}

std::unique_ptr<Engine> MakeOdeEngine(const Scene& /*scene*/) {
  assert(false);  // scenarios that ask for it are refused
  return nullptr;
}

}  // namespace plsc
