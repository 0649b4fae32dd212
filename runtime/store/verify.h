#pragma once

// Whether a file is a run's store, and whether it is whole: nothing is changed
// by asking. What a disk, an editor or a copy in the middle did to it must be
// found before a run goes on from it.

#include <set>
#include <string>

#include "grammar/failure.h"
#include "runtime/store/database.h"

namespace plsc {

/// That it is a store of this version of the schema; quick. What is wrong, or
/// nothing.
MaybeFailure CheckIdentity(Database& database);

struct Health {
  /// What is wrong first, ready for the user; nothing if all is well.
  MaybeFailure problem;
  /// From the initial one on, all of whose rows are what was written.
  int whole_generations = 0;
  bool is_run_whole = false;  ///< what the run is, with its constants
  /// By id, by id and by number: all whose rows are what was written. One who
  /// is not evaluated yet is among the evaluations.
  std::set<int> births;
  std::set<int> evaluations;
  std::set<int> generations;
};

/// Reads everything: about a second for 10,000 robots. Of one instant, if a
/// transaction is open.
Health Examine(Database& database);
/// Likewise; `problem` says what to do about it, too.
Health Examine(const std::string& path);

}  // namespace plsc
