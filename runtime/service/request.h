#pragma once

// The fields of a request, read strictly: a wrong type or an unknown key is a
// Refusal that names the key.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plsc::service {

class Request {
 public:
  /// `json` is an object.
  explicit Request(nlohmann::json json) : json_(std::move(json)) {}

  /// As it came; null without one. A Refusal if it is no text or number, or
  /// would be too long to come back with every answer.
  std::string Id() const;
  std::string Ask() const;
  /// Beside id and ask.
  void RefuseUnknown(std::span<const std::string_view> known) const;

  bool Has(std::string_view key) const { return json_.contains(key); }
  /// Must be there.
  std::string Text(std::string_view key) const;
  std::string Text(std::string_view key, std::string_view otherwise) const;
  bool Flag(std::string_view key) const;  ///< false without it
  /// A list of texts, or one text; none without it.
  std::vector<std::string> Texts(std::string_view key) const;
  /// Must be there, as the next.
  const nlohmann::json& List(std::string_view key) const;
  const nlohmann::json& Object(std::string_view key) const;
  /// A whole number of the object `of` in low..high; must be there.
  static std::int64_t Whole(const nlohmann::json& of, std::string_view key,
                            std::int64_t low, std::int64_t high);

 private:
  const nlohmann::json& Member(std::string_view key) const;

  nlohmann::json json_;
};

}  // namespace plsc::service
