#include "runtime/service/service.h"

#include <catch2/catch.hpp>

#include "runtime/service/asks.h"
#include "runtime/service/limits.h"
#include "tests/runtime/service/asked.h"

namespace plsc {
namespace {

using test::OrderedJson;

std::string ErrorIn(const std::string& answer) {
  INFO(answer.substr(0, 300));
  const auto json = nlohmann::json::parse(answer);
  CHECK(json["ok"] == false);
  return json["error"];
}

TEST_CASE("an answer has the id and the ask of its request", "[service]") {
  for (const OrderedJson& id :
       {OrderedJson(7), OrderedJson("a \"b\" \u00e9"), OrderedJson(nullptr),
        OrderedJson(-1.5), OrderedJson(true)}) {
    const OrderedJson answer = test::Answered({{"id", id}, {"ask", "about"}});
    CHECK(answer["id"] == id);
    CHECK(answer["ask"] == "about");
    CHECK(answer["ok"] == true);
    const OrderedJson refused = test::Answered({{"id", id}, {"ask", "no"}});
    CHECK(refused["id"] == id);
    CHECK(refused["ask"] == "no");
    CHECK(refused["ok"] == false);
  }
}

TEST_CASE("a service says what it is and what may be asked", "[service]") {
  const OrderedJson about = test::Answered({{"ask", "about"}});
  CHECK(about["version"] == "1.2.3");
  CHECK(about["engines"] == OrderedJson::array({"ode", "articulated"}));
  CHECK(about["limits"]["symbols"] == service::kMostSymbols);
  for (const service::Ask& ask : service::Asks()) {
    INFO(ask.name);
    const OrderedJson& names = about["asks"];
    CHECK(std::find(names.begin(), names.end(), ask.name) != names.end());
    // What needs a text says so in words.
    if (std::find(ask.keys.begin(), ask.keys.end(), "text") != ask.keys.end())
      CHECK(test::WordsOf({{"ask", ask.name}}).starts_with("expected a key '"));
    CHECK(test::WordsOf({{"ask", ask.name}, {"nonsense", 1}}) ==
          "'" + std::string(ask.name) + "' knows no key 'nonsense'");
  }
}

TEST_CASE("what is no request is answered with words", "[service]") {
  Service service("1");
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("nonsense"),
        std::string("[]"), std::string("1"), std::string("null"),
        std::string("{}"), std::string("{\"ask\":1}"),
        std::string("{\"ask\":\"check\",\"ask\":\"check\"}"),
        std::string("{\"id\":1e999,\"ask\":\"about\"}"),
        std::string("{\"id\":NaN,\"ask\":\"about\"}"),
        std::string("{\"id\":[],\"ask\":\"about\"}"),
        "{\"id\":\"" + std::string(1000, 'x') + "\",\"ask\":\"about\"}",
        std::string("{\"ask\":\"\\ud800\"}"), std::string("\xFF\xFE{}"),
        std::string("\0{}", 3), std::string(1000000, '['),
        "{\"ask\":\"check\",\"text\":" + std::string(1000, '[') +
            std::string(1000, ']') + "}",
        std::string(service::kMostRequestBytes + 1, ' ')})
    CHECK_FALSE(ErrorIn(service.Answer(text)).empty());
  CHECK(ErrorIn(service.Answer("[]")) == "expected one JSON object a request");
  CHECK(ErrorIn(service.Answer("{}")) == "expected a key 'ask'");
  // And it goes on.
  CHECK(service.Answer(R"({"ask":"about"})")
            .starts_with(R"({"id":null,"ask":"about","ok":true,)"));
}

TEST_CASE("every key may have any value", "[service]") {
  const std::vector<OrderedJson> wrong = {
      nullptr,
      true,
      -1,
      1.5,
      1e300,
      OrderedJson::array(),
      OrderedJson::object(),
      "",
      "x",
      "a\nb\x01",
      OrderedJson::array({1}),
      OrderedJson::array({"x"}),
      OrderedJson({{"line", -1}, {"column", 0}}),
      OrderedJson({{"line", 1}}),
      18446744073709551615U};
  Service service("1");
  for (const service::Ask& ask : service::Asks())
    for (const std::string_view key : ask.keys)
      for (const OrderedJson& value : wrong) {
        OrderedJson request = {{"ask", ask.name},
                               {"text",
                                "plsc 1\nalphabet plasticoding 1\n"
                                "rule C -> { C }\n"},
                               {"scenario", test::ShortScenario()}};
        for (const char* given : {"text", "scenario"})
          if (std::find(ask.keys.begin(), ask.keys.end(), given) ==
              ask.keys.end())
            request.erase(given);
        request[key] = value;
        INFO(request.dump());
        const auto answer =
            nlohmann::json::parse(service.Answer(request.dump()));
        CHECK(answer["ok"].is_boolean());
        if (answer["ok"] == false) CHECK(answer["error"] != "");
      }
}

}  // namespace
}  // namespace plsc
