// Strict reading of a value that was parsed: what has another type or range,
// what is missing and what nobody knows are errors with the path to their
// value, which json_place turns into a place. Errors give a harmless value and
// reading goes on, so that all of a file are found at once; at most kMaxErrors,
// as each costs a scan of the text.

#include "runtime/text/json_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "grammar/suggest.h"
#include "runtime/text/json_place.h"

namespace plsc {

namespace {

// How many characters of a wrong value a message shows.
constexpr std::size_t kExcerptCharacters = 40;

std::vector<std::string> PathOf(const JsonValue& value) {
  std::vector<std::string> path;
  for (const JsonValue* at = &value; at->parent != nullptr; at = at->parent)
    path.push_back(at->step);
  std::reverse(path.begin(), path.end());
  return path;
}

std::string Excerpt(const nlohmann::json& json) {
  if (json.is_object()) return "an object";
  if (json.is_array()) return "a list";
  std::string text = json.dump(-1, ' ', true);  // ASCII, so it may be cut
  if (text.size() > kExcerptCharacters)
    text = text.substr(0, kExcerptCharacters) + "...";
  return text;
}

// " for 'weight'", " in 'active_rules'".
std::string Where(const JsonValue& value) {
  if (value.parent == nullptr) return "";
  if (!value.parent->json.is_array()) return " for '" + value.step + "'";
  return " in '" + value.parent->step + "'";
}

}  // namespace

void JsonReader::Error(const JsonValue& at, Code code, std::string message,
                       std::string help) {
  if (reporter_.is_full()) return;
  reporter_
      .Report(code, JsonPlaceOf(source_.text(), PathOf(at)), std::move(message))
      .WithHelp(std::move(help));
}

void JsonReader::Wrong(const JsonValue& value, std::string_view expected,
                       Code code) {
  Error(value, code,
        fmt::format("expected {}{}, found {}", expected, Where(value),
                    Excerpt(value.json)));
}

bool JsonReader::IsObject(const JsonValue& value,
                          std::span<const std::string_view> known) {
  if (!value.json.is_object()) {
    Wrong(value, "an object");
    return false;
  }
  for (const auto& [key, member] : value.json.items()) {
    if (reporter_.is_full()) return false;
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const auto nearest = Suggest(key, known);
    const JsonValue at{member, &value, key};
    reporter_
        .Report(Code::kUnknownKey, JsonKeyPlaceOf(source_.text(), PathOf(at)),
                fmt::format("unknown key '{}'", key))
        .WithHelp(nearest
                      ? fmt::format("did you mean '{}'?", *nearest)
                      : fmt::format("known here: {}", fmt::join(known, ", ")));
  }
  return true;
}

bool JsonReader::Has(const JsonValue& object, std::string_view key) const {
  return object.json.contains(key);
}

const nlohmann::json* JsonReader::Member(const JsonValue& object,
                                         std::string_view key) {
  const auto found = object.json.find(key);
  if (found != object.json.end()) return &*found;
  Error(object, Code::kMissingKey,
        fmt::format("the key '{}' is missing here", key));
  return nullptr;
}

std::string JsonReader::Text(const JsonValue& value) {
  if (value.json.is_string()) return value.json.get<std::string>();
  Wrong(value, "a text");
  return "";
}

double JsonReader::Number(const JsonValue& value) {
  // Beyond the doubles nlohmann-json reads infinity.
  if (value.json.is_number() && std::isfinite(value.json.get<double>()))
    return value.json.get<double>();
  Wrong(value, "a number");
  return 0;
}

std::int64_t JsonReader::Integer(const JsonValue& value, std::int64_t low,
                                 std::int64_t high) {
  const bool is_huge =
      value.json.is_number_unsigned() &&
      value.json.get<std::uint64_t>() > static_cast<std::uint64_t>(high);
  const bool is_whole = value.json.is_number_integer();
  if (is_whole && !is_huge) {
    const auto number = value.json.get<std::int64_t>();
    if (number >= low && number <= high) return number;
  }
  Wrong(value, fmt::format("a whole number in {}..{}", low, high),
        is_whole ? Code::kOutOfRange : Code::kWrongKind);
  return low;
}

std::string JsonReader::Text(const JsonValue& object, std::string_view key) {
  const nlohmann::json* member = Member(object, key);
  if (member == nullptr) return "";
  return Text(JsonValue{*member, &object, std::string(key)});
}

double JsonReader::Number(const JsonValue& object, std::string_view key) {
  const nlohmann::json* member = Member(object, key);
  if (member == nullptr) return 0;
  return Number(JsonValue{*member, &object, std::string(key)});
}

std::int64_t JsonReader::Integer(const JsonValue& object, std::string_view key,
                                 std::int64_t low, std::int64_t high) {
  const nlohmann::json* member = Member(object, key);
  if (member == nullptr) return low;
  return Integer(JsonValue{*member, &object, std::string(key)}, low, high);
}

bool JsonReader::IsReadable(const JsonValue& root, std::string_view key,
                            int newest, std::string_view what) {
  const std::int64_t version =
      Integer(root, key, 1, std::numeric_limits<int>::max());
  if (version > newest)
    With(root, key, [&](const JsonValue& value) {
      Error(value, Code::kNewerVersion,
            fmt::format("this {} is of version {}, and this plsc reads version "
                        "{}",
                        what, version, newest),
            "use a newer plsc");
    });
  return errors().empty();
}

std::optional<double> JsonReader::NumberIfAny(const JsonValue& object,
                                              std::string_view key) {
  std::optional<double> number;
  With(object, key, [&](const JsonValue& value) {
    if (!value.json.is_null()) number = Number(value);
  });
  return number;
}

}  // namespace plsc
