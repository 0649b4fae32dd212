#include "runtime/lsp/rpc.h"

#include <catch2/catch.hpp>
#include <vector>

namespace plsc::lsp {

namespace {

// The code of the error that a body gets, or 0.
int ErrorOf(const std::string& body) {
  const auto parsed = ParseMessage(body);
  const auto* error = std::get_if<std::string>(&parsed);
  if (error == nullptr) return 0;
  return Json::parse(*error)["error"]["code"].get<int>();
}

}  // namespace

TEST_CASE("Requests and notifications are told apart by their id", "[lsp]") {
  const auto request = std::get<Message>(
      ParseMessage(R"({"jsonrpc":"2.0","id":"a","method":"m","params":[1]})"));
  CHECK(request.is_request());
  CHECK(request.id == "a");
  CHECK(request.method == "m");
  CHECK(request.params == Json::array({1}));
  const auto notification =
      std::get<Message>(ParseMessage(R"({"jsonrpc":"2.0","method":"m"})"));
  CHECK_FALSE(notification.is_request());
  CHECK(notification.params.is_null());
}

TEST_CASE("The client's answers are recognised", "[lsp]") {
  for (const char* body :
       {R"({"jsonrpc":"2.0","id":1,"result":null})",
        R"({"jsonrpc":"2.0","id":1,"error":{"code":1,"message":"no"}})"})
    CHECK(std::holds_alternative<ClientResponse>(ParseMessage(body)));
}

TEST_CASE("Bodies that are no messages get JSON-RPC's errors", "[lsp]") {
  struct Row {
    const char* why;
    std::string body;
    int code;
  };
  const std::vector<Row> rows = {
      {"empty", "", -32700},
      {"no JSON", "hello", -32700},
      {"cut off", R"({"jsonrpc":"2.0","id":1,)", -32700},
      {"invalid UTF-8", "{\"method\":\"\xFF\xFE\"}", -32700},
      {"a lone surrogate", R"({"method":"\ud800"})", -32700},
      {"a zero byte", std::string("{\"method\":\"a\0\"}", 14), -32700},
      {"a number", "1", -32600},
      {"a batch", R"([{"jsonrpc":"2.0","id":1,"method":"m"}])", -32600},
      {"no method", R"({"jsonrpc":"2.0","id":1})", -32600},
      {"method no string", R"({"id":1,"method":7})", -32600},
      {"id an object", R"({"id":{},"method":"m"})", -32600},
      {"id null", R"({"id":null,"method":"m"})", -32600},
      {"params a string", R"({"id":1,"method":"m","params":"x"})", -32600},
      {"a million brackets", std::string(1000000, '['), -32700},
      {"a million objects",
       [] {
         std::string deep;
         for (int i = 0; i < 1000000; ++i) deep += "{\"a\":";
         return deep;
       }(),
       -32700},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(ErrorOf(row.body) == row.code);
    }
  }
}

TEST_CASE("Brackets in strings are no depth", "[lsp]") {
  const std::string brackets(1000, '[');
  CHECK(ErrorOf(R"({"id":1,"method":"\")" + brackets + R"("})") == 0);
}

TEST_CASE("Bodies that are sent are UTF-8 whatever is in them", "[lsp]") {
  const std::string body = ErrorBody(1, ErrorCode::kRequestFailed, "\xFF");
  CHECK(Json::parse(body)["error"]["message"] == "\xEF\xBF\xBD");
  CHECK(Json::parse(ResponseBody("x", nullptr)) ==
        Json({{"jsonrpc", "2.0"}, {"id", "x"}, {"result", nullptr}}));
  CHECK_FALSE(Json::parse(RequestBody(3, "m", nullptr)).contains("params"));
  CHECK(Json::parse(NotificationBody("m", Json::array()))["params"] ==
        Json::array());
}

}  // namespace plsc::lsp
