#pragma once

// What stands behind '?' in an address.

#include <optional>
#include <string>
#include <string_view>

namespace plsc::server {

/// The value of `name` in "a=1&b=x%2Fy", decoded; nothing if it is not there
/// or is no such text.
std::optional<std::string> QueryValue(std::string_view query,
                                      std::string_view name);

}  // namespace plsc::server
