#include "runtime/store/versions.h"

#include <fmt/format.h>

#include "sim/machine_kind.h"
#include "sim/results.h"

namespace plsc {

Versions ThisProgram() {
  static const std::string machine = MachineKind();  // takes a millisecond
  return {PLSC_VERSION, PLSC_ODE_VERSION, __VERSION__, machine, kResults};
}

Versions VersionsFor(const Scenario& scenario) {
  Versions versions = ThisProgram();
  if (!UsesOde(scenario)) versions.machine = kAnyMachine;
  return versions;
}

bool MakeTheSame(const Versions& one, const Versions& other) {
  if (one.results != other.results || one.plsc != other.plsc) return false;
  const bool is_anywhere =
      one.machine == kAnyMachine || other.machine == kAnyMachine;
  return is_anywhere ||
         (one.ode == other.ode && one.compiler == other.compiler &&
          one.machine == other.machine);
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
  if (versions.results != own.results)
    return fmt::format(
        "'{}' was made by other arithmetic: its results have number {} (plsc "
        "{}), those of this program {}; to go on would mix both (plsc {} goes "
        "on with it; where that does not matter: --allow-other-version)",
        path, versions.results, versions.plsc, own.results, versions.plsc);
  if (auto failure = differs("plsc", versions.plsc, own.plsc)) return failure;
  if (versions.machine == kAnyMachine) return std::nullopt;
  if (auto failure = differs("ODE", versions.ode, own.ode)) return failure;
  if (auto failure = differs("compiler", versions.compiler, own.compiler))
    return failure;
  return differs("machine", versions.machine, own.machine);
}

}  // namespace plsc
