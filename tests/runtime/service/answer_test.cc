#include "runtime/service/answer.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace plsc::service {
namespace {

TEST_CASE("an answer's members stand in order, whatever bytes they have",
          "[service]") {
  Answer answer;
  answer.AddMembers("");
  answer.Add("first", "a\"\xFF");
  answer.AddWritten("second", "[1, 2]");
  answer.AddMembers("\"third\":3,\"fourth\":4");
  CHECK(answer.members() ==
        "\"first\":\"a\\\"\xEF\xBF\xBD\",\"second\":[1, 2],\"third\":3,"
        "\"fourth\":4");
  CHECK(nlohmann::json::accept("{" + answer.members() + "}"));
}

}  // namespace
}  // namespace plsc::service
