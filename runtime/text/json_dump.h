#pragma once

// JSON as text that is UTF-8 whatever it is about: a file's name may be any
// bytes, and the library would throw.

#include <nlohmann/json.hpp>
#include <string>

namespace plsc {

/// One line; bytes that are no UTF-8 become U+FFFD. `indent` as the library's.
template <typename Json>
std::string DumpJson(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace plsc
