#pragma once

// The time of day, as logs, stores and records have it.

#include <fmt/chrono.h>

#include <ctime>
#include <string>

namespace plsc::cli {

/// "2026-11-30T12:00:00Z"
inline std::string UtcNow() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

}  // namespace plsc::cli
