#pragma once

// What `plsc relive` does with one run, and `plsc report --relive` with many:
// lives what is missing in RUN.relived.sqlite, on workers, each life kept as it
// ends.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "runtime/cli/files/io.h"
#include "runtime/relive/orders.h"
#include "runtime/report/relived_run.h"

namespace plsc::cli {

/// Lives lived by now, of those that were missing.
using OnLived = std::function<void(std::int64_t done, std::int64_t total)>;

struct ReliveOutcome {
  /// kInterrupted: stopped by a signal (InterruptHandler), to be gone on with.
  /// kBadInput: `failure` says why.
  Exit exit = Exit::kFine;
  MaybeFailure failure;
  std::int64_t lived = 0;    ///< now
  std::int64_t before = 0;   ///< seasons that were there
  std::int64_t deaths = 0;   ///< lives that ended with their workers, now
  std::int64_t missing = 0;  ///< lives, when it began
  /// What the user must know, of who cannot live by the other engine, or of
  /// other arithmetic; empty: nothing.
  std::string note;
  std::optional<RelivedRun> result;  ///< of the generations that were chosen
};

/// `jobs` as RunRequest's.
ReliveOutcome ReliveRun(const std::string& run, const ReliveRequest& request,
                        std::optional<int> jobs, const OnLived& on_lived);

}  // namespace plsc::cli
