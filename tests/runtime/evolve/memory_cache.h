#pragma once

// A shared cache without a file.

#include <map>
#include <optional>
#include <string>

#include "runtime/evolve/simulation_cache.h"
#include "runtime/life/simulated.h"

namespace plsc::test {

/// Simulations by key, as a shared cache has them.
class MemoryCache : public SimulationCache {
 public:
  std::map<Key, Simulated> known;
  std::optional<Simulated> Find(const Key& key) override {
    const auto found = known.find(key);
    if (found == known.end()) return std::nullopt;
    return found->second;
  }
  MaybeFailure Add(const Key& key, const Simulated& simulated) override {
    known.emplace(key, simulated);
    return std::nullopt;
  }
};

}  // namespace plsc::test
