#include <catch2/catch.hpp>

#include "runtime/lsp/server.h"
#include "runtime/service/service.h"
#include "tests/runtime/service/asked.h"

namespace plsc {
namespace {

using test::OrderedJson;

OrderedJson Opened(const std::string& text) {
  return {{"jsonrpc", "2.0"},
          {"method", "textDocument/didOpen"},
          {"params",
           {{"textDocument",
             {{"uri", "file:///robot.pls"},
              {"languageId", "pls"},
              {"version", 1},
              {"text", text}}}}}};
}

OrderedJson Called(int id, const char* method, OrderedJson params) {
  return {{"jsonrpc", "2.0"},
          {"id", id},
          {"method", method},
          {"params", std::move(params)}};
}

TEST_CASE("the language server answers through the service as it does alone",
          "[service]") {
  const std::vector<OrderedJson> messages = {
      Called(1, "initialize", {{"capabilities", OrderedJson::object()}}),
      {{"jsonrpc", "2.0"},
       {"method", "initialized"},
       {"params", OrderedJson::object()}},
      Opened("plsc 1\nalphabet plasticoding 1\nrule C -> { C add_frnt B }\n"),
      Called(2, "textDocument/hover",
             {{"textDocument", {{"uri", "file:///robot.pls"}}},
              {"position", {{"line", 2}, {"character", 23}}}}),
      Called(3, "shutdown", nullptr),
      {{"jsonrpc", "2.0"}, {"method", "exit"}}};
  Service service("7");
  lsp::Server server("7");
  std::size_t sent = 0;
  const auto check = [&](const OrderedJson& request,
                         const std::vector<std::string>& expected) {
    const auto answer = nlohmann::json::parse(service.Answer(request.dump()));
    INFO(answer.dump());
    REQUIRE(answer["ok"] == true);
    REQUIRE(answer["messages"].size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
      CHECK(answer["messages"][i] == nlohmann::json::parse(expected[i]));
    CHECK(answer["has_work"] == server.has_work());
    sent += expected.size();
  };
  for (const OrderedJson& message : messages) {
    check({{"ask", "lsp"}, {"message", message}},
          server.Handle(message.dump()));
    while (server.has_work()) check({{"ask", "idle"}}, server.Idle());
  }
  CHECK(sent >= 4);
  // After `exit` it begins anew.
  const auto again = nlohmann::json::parse(service.Answer(
      OrderedJson({{"ask", "lsp"}, {"message", messages[0]}}).dump()));
  CHECK(again["messages"][0]["result"].contains("capabilities"));
}

TEST_CASE("a service without documents has nothing to do", "[service]") {
  const OrderedJson answer = test::Answered({{"ask", "idle"}});
  CHECK(answer["messages"].empty());
  CHECK(answer["has_work"] == false);
  CHECK(test::WordsOf({{"ask", "lsp"}}) == "expected a key 'message'");
  // What is no message is the language server's to say.
  const OrderedJson odd =
      test::Answered({{"ask", "lsp"}, {"message", OrderedJson::object()}});
  CHECK(odd["messages"][0].contains("error"));
}

}  // namespace
}  // namespace plsc
