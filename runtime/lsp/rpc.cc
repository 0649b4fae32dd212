#include "runtime/lsp/rpc.h"

#include <fmt/format.h>

#include <utility>

#include "runtime/text/json_dump.h"
#include "runtime/text/json_place.h"

namespace plsc::lsp {

namespace {

std::string Text(const Json& json) {
  return DumpJson(json);
}

bool IsId(const Json& id) {
  return id.is_number_integer() || id.is_string();
}

std::string NoRequest(const Json& id, const std::string& message) {
  return ErrorBody(id, ErrorCode::kInvalidRequest, message);
}

}  // namespace

std::variant<Message, ClientResponse, std::string> ParseMessage(
    std::string_view body) {
  if (TooDeepInJson(body))
    return ErrorBody(nullptr, ErrorCode::kParseError,
                     fmt::format("expected at most {} brackets around a value",
                                 kMaxJsonDepth));
  Json json = Json::parse(body, nullptr, /*allow_exceptions=*/false);
  if (json.is_discarded())
    return ErrorBody(nullptr, ErrorCode::kParseError, "expected JSON in UTF-8");
  if (!json.is_object())
    return NoRequest(nullptr, "expected one JSON object a message");

  Message message;
  if (const auto id = json.find("id"); id != json.end()) {
    if (!IsId(*id))
      return NoRequest(nullptr, "expected an integer or string id");
    message.id = std::move(*id);
  }
  const auto method = json.find("method");
  if (method == json.end()) {
    if (json.contains("result") || json.contains("error"))
      return ClientResponse{};
    return NoRequest(message.id, "expected a method");
  }
  if (!method->is_string())
    return NoRequest(message.id, "expected the method to be a string");
  message.method = method->get<std::string>();
  if (const auto params = json.find("params"); params != json.end()) {
    if (!params->is_structured() && !params->is_null())
      return NoRequest(message.id, "expected params to be an object or array");
    message.params = std::move(*params);
  }
  return message;
}

std::string ResponseBody(const Json& id, Json result) {
  Json body = {{"jsonrpc", "2.0"}, {"id", id}};
  body["result"] = std::move(result);
  return Text(body);
}

std::string ErrorBody(const Json& id, ErrorCode code,
                      const std::string& message) {
  Json body = {{"jsonrpc", "2.0"}, {"id", id}};
  body["error"] = {{"code", static_cast<int>(code)}, {"message", message}};
  return Text(body);
}

std::string NotificationBody(const char* method, Json params) {
  Json body = {{"jsonrpc", "2.0"}, {"method", method}};
  body["params"] = std::move(params);
  return Text(body);
}

std::string RequestBody(int id, const char* method, Json params) {
  Json body = {{"jsonrpc", "2.0"}, {"id", id}, {"method", method}};
  if (!params.is_null()) body["params"] = std::move(params);
  return Text(body);
}

}  // namespace plsc::lsp
