#pragma once

// What made a run's results, besides the experiment: of a run of which ODE
// lives a season the compiler and the machine, too; one of the articulated
// engine alone comes to the same bits everywhere.

#include <string>

#include "grammar/failure.h"
#include "runtime/scenario/scenario.h"

namespace plsc {

/// Where neither the machine nor the compiler nor ODE changes a bit.
inline constexpr const char* kAnyMachine = "any";

struct Versions {
  std::string plsc;
  std::string ode;
  std::string compiler;
  /// Its kind (sim/machine_kind.h), or kAnyMachine.
  std::string machine;
  int results = 0;  ///< the number of the arithmetic (sim/results.h)

  friend bool operator==(const Versions&, const Versions&) = default;
};

/// Of this program, here.
Versions ThisProgram();
/// Of a run of this program that lives the scenario.
Versions VersionsFor(const Scenario& scenario);

/// Whether programs of these versions make the same run of an experiment, bit
/// for bit.
bool MakeTheSame(const Versions& one, const Versions& other);

/// What keeps this program from going on with a run of those versions, ready to
/// be printed; or nothing. `path` is the run's, for the message.
MaybeFailure CheckVersions(const std::string& path, const Versions& versions);

}  // namespace plsc
