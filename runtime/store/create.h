#pragma once

// A run's store as it is before anybody is born.

#include <string>

#include "grammar/failure.h"
#include "runtime/evolve/experiment.h"
#include "runtime/store/lock.h"
#include "runtime/store/versions.h"

namespace plsc {

/// Makes the file as a whole or not at all: `path` must not exist. What went
/// wrong, or nothing; then `lock` is on it from its first instant.
MaybeFailure CreateStoreFile(const std::string& path,
                             const Experiment& experiment,
                             const Versions& versions, RunLock& lock);

}  // namespace plsc
