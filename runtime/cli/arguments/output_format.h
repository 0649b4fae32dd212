#pragma once

// How commands print, where several let one choose.

#include <cstdint>

namespace plsc::cli {

enum class OutputFormat : std::uint8_t { kText, kJson };

/// kAuto: when standard error is a terminal and NO_COLOR is not set.
enum class ColorChoice : std::uint8_t { kAuto, kAlways, kNever };

}  // namespace plsc::cli
