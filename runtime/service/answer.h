#pragma once

// An answer on its way: members of a JSON object, in order. Put together as
// text, as most of its parts are written already by the rooms below, and
// recordings are megabytes.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace plsc::service {

class Answer {
 public:
  /// `json`: a value, written.
  void AddWritten(std::string_view key, std::string_view json);
  void Add(std::string_view key, const nlohmann::ordered_json& value);
  /// `"key":value,"key":value`, written; may be empty.
  void AddMembers(std::string_view members);

  /// Without the brackets of the object.
  const std::string& members() const { return members_; }

 private:
  std::string members_;
};

/// As JSON; bytes that are no UTF-8 become U+FFFD.
std::string Quoted(std::string_view text);

}  // namespace plsc::service
