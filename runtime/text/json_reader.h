#pragma once

// Strict reading of a JSON file of ours: values of the right type,
// no unknown keys, all errors of a file in one go, each at its place. Knows no
// meaning of keys.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/reporter.h"

namespace plsc {

/// A value and how one got there. Lives no longer than its parent.
struct JsonValue {
  const nlohmann::json& json;
  const JsonValue* parent = nullptr;
  std::string step;  ///< key or position in the parent
};

/// What is wrong reads as a default.
class JsonReader {
 public:
  explicit JsonReader(const Source& source) : source_(source) {}

  /// The errors found; none: all values that were read are good.
  const std::vector<Diagnostic>& errors() const {
    return reporter_.diagnostics();
  }
  void Error(const JsonValue& at, Code code, std::string message,
             std::string help = "");

  /// Reports keys that are not among `known`, and what is no object.
  bool IsObject(const JsonValue& value,
                std::span<const std::string_view> known);
  bool Has(const JsonValue& object, std::string_view key) const;
  std::string Text(const JsonValue& object, std::string_view key);
  double Number(const JsonValue& object, std::string_view key);
  std::int64_t Integer(const JsonValue& object, std::string_view key,
                       std::int64_t low, std::int64_t high);

  /// Whether the version of a file's format, under `key`, is at most `newest`:
  /// a newer file is refused with one message, not one for every new key.
  /// `what` is the file: "recording".
  bool IsReadable(const JsonValue& root, std::string_view key, int newest,
                  std::string_view what);
  /// Nothing for null.
  std::optional<double> NumberIfAny(const JsonValue& object,
                                    std::string_view key);

  /// Calls `read` with the member, or reports that it is missing.
  template <typename Read>
  void With(const JsonValue& object, std::string_view key, Read read) {
    if (const nlohmann::json* member = Member(object, key))
      read(JsonValue{*member, &object, std::string(key)});
  }

  /// Calls `read` with every element of a list.
  template <typename Read>
  void List(const JsonValue& object, std::string_view key, Read read) {
    const nlohmann::json* list = Member(object, key);
    if (list == nullptr) return;
    const JsonValue value{*list, &object, std::string(key)};
    if (!list->is_array()) return Wrong(value, "a list");
    for (std::size_t i = 0; i < list->size(); ++i)
      read(JsonValue{(*list)[i], &value, std::to_string(i)});
  }
  /// The text of an element.
  std::string Text(const JsonValue& value);
  double Number(const JsonValue& value);
  std::int64_t Integer(const JsonValue& value, std::int64_t low,
                       std::int64_t high);
  /// The member, or an error and nothing.
  const nlohmann::json* Member(const JsonValue& object, std::string_view key);
  void Wrong(const JsonValue& value, std::string_view expected,
             Code code = Code::kWrongKind);

 private:
  // As many as a rendering shows: each is looked for from the file's beginning.
  static constexpr std::size_t kMaxErrors = 20;

  const Source& source_;
  // Asked for room before a place is looked for.
  Reporter reporter_{kMaxErrors};
};

}  // namespace plsc
