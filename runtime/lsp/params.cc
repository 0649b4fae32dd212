#include "runtime/lsp/params.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "runtime/lsp/rpc.h"

namespace plsc::lsp {

namespace {

[[noreturn]] void Expect(const char* key, const char* what) {
  throw Fault(ErrorCode::kInvalidParams,
              fmt::format("expected '{}' to be {}", key, what));
}

std::uint32_t ReadCount(const Json& object, const char* key) {
  const Json& value = ReadKey(object, key);
  if (!value.is_number_integer()) Expect(key, "a whole number from 0");
  // Unsigned ones may be beyond what a signed one holds.
  if (!value.is_number_unsigned()) Expect(key, "a whole number from 0");
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  return static_cast<std::uint32_t>(
      std::min(value.get<std::uint64_t>(), kMost));
}

Place ToPlace(const Json& json) {
  return {ReadCount(json, "line"), ReadCount(json, "character")};
}

}  // namespace

const Json& ReadKey(const Json& object, const char* key) {
  if (!object.is_object()) Expect(key, "in an object");
  const auto found = object.find(key);
  if (found == object.end()) Expect(key, "there");
  return *found;
}

const std::string& ReadString(const Json& object, const char* key) {
  const Json& value = ReadKey(object, key);
  if (!value.is_string()) Expect(key, "a string");
  return value.get_ref<const std::string&>();
}

Place ReadPlace(const Json& object, const char* key) {
  return ToPlace(ReadKey(object, key));
}

PlaceRange ReadRange(const Json& object, const char* key) {
  const Json& range = ReadKey(object, key);
  return {ReadPlace(range, "start"), ReadPlace(range, "end")};
}

const std::string& ReadUri(const Json& params) {
  return ReadString(ReadKey(params, "textDocument"), "uri");
}

std::string OptionalString(const Json& object, const char* key) {
  if (!object.is_object()) return "";
  const auto found = object.find(key);
  if (found == object.end() || !found->is_string()) return "";
  return found->get<std::string>();
}

bool IsTrue(const Json& object, std::initializer_list<const char*> keys) {
  const Json* at = &object;
  for (const char* key : keys) {
    if (!at->is_object()) return false;
    const auto found = at->find(key);
    if (found == at->end()) return false;
    at = &*found;
  }
  return at->is_boolean() && at->get<bool>();
}

Json PlaceJson(Place place) {
  return {{"line", place.line}, {"character", place.character}};
}

Json RangeJson(const PlaceRange& range) {
  return {{"start", PlaceJson(range.start)}, {"end", PlaceJson(range.end)}};
}

Json TextEditJson(const LineTable& lines, Span span,
                  const std::string& replacement) {
  return {{"range", RangeJson(lines.RangeOf(span))}, {"newText", replacement}};
}

Json WorkspaceEditJson(const std::string& uri, Json edits) {
  Json changes = Json::object();
  changes[uri] = std::move(edits);
  Json edit = Json::object();
  edit["changes"] = std::move(changes);
  return edit;
}

Json MarkdownJson(std::string text) {
  return {{"kind", "markdown"}, {"value", std::move(text)}};
}

}  // namespace plsc::lsp
