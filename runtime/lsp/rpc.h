#pragma once

// JSON-RPC 2.0 as LSP uses it: a body to a request or a notification, and
// answers to bodies. Knows no method.

#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include "runtime/lsp/json.h"

namespace plsc::lsp {

/// Codes of JSON-RPC and of LSP 3.17.
enum class ErrorCode : int {
  kParseError = -32700,
  kInvalidRequest = -32600,
  kMethodNotFound = -32601,
  kInvalidParams = -32602,
  kInternalError = -32603,
  kServerNotInitialized = -32002,
  kRequestFailed = -32803,
};

/// Why a request gets an error for an answer. Thrown by what serves a request,
/// caught by the Server; leaves runtime/lsp nowhere.
class Fault : public std::runtime_error {
 public:
  Fault(ErrorCode code, const std::string& message)
      : std::runtime_error(message), code_(code) {}
  ErrorCode code() const { return code_; }

 private:
  ErrorCode code_;
};

// JSON says that moving and destroying it never throw, and clang-tidy does not
// believe it.
struct Message {  // NOLINT(bugprone-exception-escape)
  Json id;        ///< null: a notification
  std::string method;
  Json params;  ///< null when there are none

  bool is_request() const { return !id.is_null(); }
};

/// The answer of the client to a request of ours.
struct ClientResponse {};

/// What the body says, or the error to send back.
std::variant<Message, ClientResponse, std::string> ParseMessage(
    std::string_view body);

/// Bodies. Bytes that are no UTF-8 are replaced.
std::string ResponseBody(const Json& id, Json result);
std::string ErrorBody(const Json& id, ErrorCode code,
                      const std::string& message);
std::string NotificationBody(const char* method, Json params);
std::string RequestBody(int id, const char* method, Json params);

}  // namespace plsc::lsp
