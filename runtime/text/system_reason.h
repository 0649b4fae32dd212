#pragma once

// Why the system refused something, in its own words.

#include <string>
#include <system_error>

namespace plsc {

/// Of an errno: "No such file or directory".
inline std::string SystemReason(int error) {
  return std::error_code(error, std::generic_category()).message();
}

}  // namespace plsc
