#pragma once

// What made a run's results, besides the experiment.

#include <string>

#include "grammar/failure.h"

namespace plsc {

struct Versions {
  std::string plsc;
  std::string ode;
  std::string compiler;
  std::string machine;  ///< its kind (sim/machine_kind.h)

  friend bool operator==(const Versions&, const Versions&) = default;
};

/// Of this program.
Versions ThisProgram();

/// What keeps this program from going on with a run of those versions, ready to
/// be printed; or nothing. `path` is the run's, for the message.
MaybeFailure CheckVersions(const std::string& path, const Versions& versions);

}  // namespace plsc
