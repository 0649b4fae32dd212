#include "runtime/store/versions.h"

#include <fmt/format.h>

#include "sim/machine_kind.h"

namespace plsc {

Versions ThisProgram() {
  static const std::string machine = MachineKind();  // takes a millisecond
  return {PLSC_VERSION, PLSC_ODE_VERSION, __VERSION__, machine};
}

MaybeFailure CheckVersions(const std::string& path, const Versions& versions) {
  const Versions own = ThisProgram();
  const auto differs = [&](const char* what, const std::string& then,
                           const std::string& now) -> MaybeFailure {
    if (then == now) return std::nullopt;
    return fmt::format(
        "'{}' was begun with {} {}, and this is {}: to go on would not give "
        "the results of a run that was never interrupted (where that does not "
        "matter: --allow-other-version)",
        path, what, then, now);
  };
  if (auto failure = differs("plsc", versions.plsc, own.plsc)) return failure;
  if (auto failure = differs("ODE", versions.ode, own.ode)) return failure;
  if (auto failure = differs("compiler", versions.compiler, own.compiler))
    return failure;
  return differs("machine", versions.machine, own.machine);
}

}  // namespace plsc
