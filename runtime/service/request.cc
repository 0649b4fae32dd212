#include "runtime/service/request.h"

#include <fmt/format.h>

#include <algorithm>

#include "grammar/suggest.h"
#include "runtime/service/limits.h"
#include "runtime/service/refusal.h"

namespace plsc::service {

namespace {

using PlainJson = nlohmann::json;

[[noreturn]] void RefuseKind(std::string_view key, std::string_view expected) {
  throw Refusal(fmt::format("expected '{}' to be {}", key, expected));
}

std::string TextOf(const PlainJson& json, std::string_view key) {
  if (!json.is_string()) RefuseKind(key, "a text");
  return json.get<std::string>();
}

}  // namespace

std::string Request::Id() const {
  const auto found = json_.find("id");
  if (found == json_.end() || found->is_null()) return "null";
  std::string id = found->is_primitive() ? found->dump() : "";
  if (id.empty() || id.size() > kMostIdBytes)
    RefuseKind("id", fmt::format("a text or a number of at most {} bytes",
                                 kMostIdBytes));
  return id;
}

std::string Request::Ask() const {
  return Text("ask");
}

void Request::RefuseUnknown(std::span<const std::string_view> known) const {
  std::vector<std::string_view> all{"id", "ask"};
  all.insert(all.end(), known.begin(), known.end());
  for (const auto& [key, value] : json_.items()) {
    if (std::find(all.begin(), all.end(), key) != all.end()) continue;
    const auto near = Suggest(key, all);
    throw Refusal(fmt::format("'{}' knows no key '{}'{}", Ask(), key,
                              near ? "; did you mean '" + *near + "'?" : ""));
  }
}

const PlainJson& Request::Member(std::string_view key) const {
  const auto found = json_.find(key);
  if (found == json_.end())
    throw Refusal(fmt::format("expected a key '{}'", key));
  return *found;
}

std::string Request::Text(std::string_view key) const {
  return TextOf(Member(key), key);
}

std::string Request::Text(std::string_view key,
                          std::string_view otherwise) const {
  return Has(key) ? Text(key) : std::string(otherwise);
}

bool Request::Flag(std::string_view key) const {
  if (!Has(key)) return false;
  const PlainJson& json = Member(key);
  if (!json.is_boolean()) RefuseKind(key, "true or false");
  return json.get<bool>();
}

std::vector<std::string> Request::Texts(std::string_view key) const {
  if (!Has(key)) return {};
  const PlainJson& json = Member(key);
  if (json.is_string()) return {json.get<std::string>()};
  if (!json.is_array()) RefuseKind(key, "a text or a list of texts");
  std::vector<std::string> texts;
  for (const PlainJson& one : json) texts.push_back(TextOf(one, key));
  return texts;
}

const PlainJson& Request::List(std::string_view key) const {
  const PlainJson& json = Member(key);
  if (!json.is_array()) RefuseKind(key, "a list");
  return json;
}

const PlainJson& Request::Object(std::string_view key) const {
  const PlainJson& json = Member(key);
  if (!json.is_object()) RefuseKind(key, "an object");
  return json;
}

std::int64_t Request::Whole(const PlainJson& of, std::string_view key,
                            std::int64_t low, std::int64_t high) {
  const auto found = of.find(key);
  if (found == of.end()) throw Refusal(fmt::format("expected a key '{}'", key));
  // Above 2^63 the library has it unsigned.
  if (!found->is_number_integer() ||
      (found->is_number_unsigned() &&
       found->get<std::uint64_t>() > static_cast<std::uint64_t>(high)) ||
      found->get<std::int64_t>() < low || found->get<std::int64_t>() > high)
    RefuseKind(key, fmt::format("a whole number in {}..{}", low, high));
  return found->get<std::int64_t>();
}

}  // namespace plsc::service
