#pragma once

// Where a run's results come from: versions, seed, constants, and what the work
// on it took. The table of provenance of a report.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/store/database.h"
#include "runtime/store/run_store.h"

namespace plsc {

/// A constant of a season, as the store has it.
struct StoredConstant {
  std::string season;
  std::string name;   ///< "physics.step"
  std::string value;  ///< a number's shortest text, or a text
  std::string unit;   ///< empty: none

  friend bool operator==(const StoredConstant&,
                         const StoredConstant&) = default;
};

/// All the sessions of a run. Of one that was killed, or that goes on, only
/// its start is known.
struct WorkDone {
  int sessions = 0;
  int open_sessions = 0;           ///< killed, or going on
  std::string first;               ///< UTC; empty without sessions
  std::string last;                ///< end of the last that ended
  std::vector<std::string> hosts;  ///< in order of appearance
  double seconds = 0;              ///< by the wall
  double cpu_seconds = 0;
  std::int64_t simulated = 0;  ///< seasons
  std::int64_t looked_up = 0;  ///< seasons
};

struct RunFacts {
  std::string name;
  std::string seed;
  Versions versions;
  int schema = 0;  ///< of the store; older ones lack MissingMeasures
  int planned_generations = 0;
  std::int64_t planned_evaluations = 0;
  std::int64_t evaluations = 0;
  int best = 0;  ///< id, of the last completed generation; 0: none
  WorkDone work;
  std::vector<StoredConstant> constants;
};

/// What cannot be read is a failure of the database.
RunFacts ReadFacts(Database& database);

}  // namespace plsc
