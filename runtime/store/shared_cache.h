#pragma once

// Simulations that several runs share, in a file of their own (`plsc evolve
// --cache FILE`). Holds no result: a run is the same without it. So what goes
// wrong with it while a run goes on ends its use and not the run, and an entry
// that is not what was written counts for nothing.

#include <memory>
#include <optional>
#include <string>

#include "grammar/failure.h"
#include "runtime/evolve/simulation_cache.h"
#include "runtime/life/simulated.h"
#include "runtime/store/database.h"
#include "runtime/store/engine.h"

namespace plsc {

/// Several processes may use one file at a time. Not to be used on both sides
/// of a fork.
class SharedCache : public SimulationCache {
 public:
  SharedCache();
  ~SharedCache() override;
  SharedCache(const SharedCache&) = delete;
  SharedCache& operator=(const SharedCache&) = delete;

  /// Makes the file if it is not there. What is wrong with it, or nothing.
  MaybeFailure Open(const std::string& path,
                    const std::string& engine = ThisEngine());

  /// Ends its use as if it had never begun: a file that Open made is deleted.
  void Discard();

  /// An entry that is damaged is dropped, and not found.
  std::optional<Simulated> Find(const Key& key) override;
  /// Never fails: see warning().
  MaybeFailure Add(const Key& key, const Simulated& simulated) override;

  /// What the user must know of it: that it is not used any more, and why;
  /// how many entries were damaged.
  MaybeFailure warning() const;

 private:
  struct Statements;
  MaybeFailure OpenFile(const std::string& path, const std::string& engine);
  void Check();
  /// Nothing if the row is not what was added under this key.
  std::optional<Simulated> TakeEntry(const std::string& key);

  Database database_;
  std::unique_ptr<Statements> statements_;
  std::string engine_;
  std::int64_t engine_id_ = 0;
  MaybeFailure gone_;    // why it is not used any more
  int damaged_ = 0;      // entries
  bool is_new_ = false;  // made by this object
};

}  // namespace plsc
