#include "sim/machine_kind.h"

#include <fmt/format.h>

#include <cmath>

#include "sim/fnv.h"

namespace plsc {

std::string MachineKind() {
  Fnv hash;
  for (int i = 1; i <= 5000; ++i) {
    const double x = 0.37 * i;
    for (const double y : {std::sin(x), std::cos(x), std::atan2(x, 1.1),
                           std::pow(x, 0.3), std::exp(-x / 100)})
      hash.Add(y);
  }
  return fmt::format("{} ode {} libm {:016x}",
#if defined(__x86_64__)
                     "x86_64",
#else
                     "other",
#endif
                     PLSC_ODE_VERSION, hash.value());
}

}  // namespace plsc
