#pragma once

// Where simulations are looked up before they are done. The keys are
// SeasonEvidence::simulation.

#include <optional>
#include <string>

#include "grammar/failure.h"
#include "runtime/life/simulated.h"
#include "runtime/text/key.h"

namespace plsc {

class SimulationCache {
 public:
  virtual ~SimulationCache() = default;
  virtual std::optional<Simulated> Find(const Key& key) = 0;
  /// What went wrong, or nothing. A key that is there already stays as it is.
  virtual MaybeFailure Add(const Key& key, const Simulated& simulated) = 0;
};

}  // namespace plsc
