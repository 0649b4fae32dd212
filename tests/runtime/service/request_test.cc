#include "runtime/service/request.h"

#include <catch2/catch.hpp>

#include "runtime/service/refusal.h"

namespace plsc::service {
namespace {

Request RequestOf(const char* json) {
  return Request(nlohmann::json::parse(json));
}

TEST_CASE("fields of a request are read strictly", "[service]") {
  const Request request = RequestOf(
      R"({"id":"a","ask":"x","text":"t","flag":true,"list":["b","c"],
          "object":{"line":3,"huge":18446744073709551615,"real":1.5}})");
  CHECK(request.Id() == "\"a\"");
  CHECK(request.Ask() == "x");
  CHECK(request.Text("text") == "t");
  CHECK(request.Text("none", "otherwise") == "otherwise");
  CHECK(request.Flag("flag"));
  CHECK_FALSE(request.Flag("none"));
  CHECK(request.Texts("list") == std::vector<std::string>{"b", "c"});
  CHECK(request.Texts("text") == std::vector<std::string>{"t"});
  CHECK(request.Texts("none").empty());
  const nlohmann::json& object = request.Object("object");
  CHECK(Request::Whole(object, "line", 1, 10) == 3);

  CHECK_THROWS_WITH(request.Text("none"), "expected a key 'none'");
  CHECK_THROWS_WITH(request.Text("flag"), "expected 'flag' to be a text");
  CHECK_THROWS_WITH(request.Flag("text"),
                    "expected 'text' to be true or false");
  CHECK_THROWS_WITH(request.Texts("flag"),
                    "expected 'flag' to be a text or a list of texts");
  CHECK_THROWS_WITH(request.Object("text"), "expected 'text' to be an object");
  for (const char* key : {"huge", "real"})
    CHECK_THROWS_AS(Request::Whole(object, key, 1, 10), Refusal);
  CHECK_THROWS_WITH(Request::Whole(object, "line", 1, 2),
                    "expected 'line' to be a whole number in 1..2");
  CHECK_THROWS_WITH(Request::Whole(object, "none", 1, 2),
                    "expected a key 'none'");
}

TEST_CASE("a key that nobody reads is an error", "[service]") {
  const Request request = RequestOf(R"({"id":1,"ask":"x","txt":"t"})");
  CHECK_THROWS_WITH(request.RefuseUnknown(std::vector<std::string_view>{}),
                    "'x' knows no key 'txt'");
  CHECK_THROWS_WITH(
      request.RefuseUnknown(std::vector<std::string_view>{"text"}),
      "'x' knows no key 'txt'; did you mean 'text'?");
  CHECK_NOTHROW(request.RefuseUnknown(std::vector<std::string_view>{"txt"}));
}

}  // namespace
}  // namespace plsc::service
