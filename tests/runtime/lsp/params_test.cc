#include "runtime/lsp/params.h"

#include <catch2/catch.hpp>

#include "runtime/lsp/rpc.h"

namespace plsc::lsp {

TEST_CASE("Places of clients are read", "[lsp]") {
  const Json params = Json::parse(R"({"position":{"line":3,"character":4},
      "range":{"start":{"line":0,"character":0},
               "end":{"line":18446744073709551615,"character":1}},
      "textDocument":{"uri":"u"}})");
  CHECK(ReadPlace(params, "position") == Place{3, 4});
  // Beyond 32 bits is beyond all lines.
  CHECK(ReadRange(params, "range").end == Place{0xFFFFFFFF, 1});
  CHECK(ReadUri(params) == "u");
}

TEST_CASE("Params of another type are faults that name the key", "[lsp]") {
  for (const char* position :
       {"null", "7", "[]", "{}", R"({"line":1})",
        R"({"line":-1,"character":0})", R"({"line":1.5,"character":0})",
        R"({"line":"1","character":0})", R"({"line":true,"character":0})"}) {
    INFO(position);
    const Json params = {{"position", Json::parse(position)}};
    CHECK_THROWS_AS(ReadPlace(params, "position"), Fault);
  }
  CHECK_THROWS_WITH(ReadString(Json::object(), "newName"),
                    "expected 'newName' to be there");
  CHECK_THROWS_WITH(ReadString({{"newName", 1}}, "newName"),
                    "expected 'newName' to be a string");
  CHECK_THROWS_AS(ReadUri(nullptr), Fault);
  CHECK_THROWS_AS(ReadUri({{"textDocument", "x"}}), Fault);
}

TEST_CASE("Optional keys of another type are as if left out", "[lsp]") {
  CHECK(OptionalString({{"a", 1}}, "a").empty());
  CHECK(OptionalString(nullptr, "a").empty());
  CHECK(OptionalString({{"a", "b"}}, "a") == "b");
  const Json deep = {{"a", {{"b", true}}}};
  CHECK(IsTrue(deep, {"a", "b"}));
  CHECK_FALSE(IsTrue(deep, {"a"}));
  CHECK_FALSE(IsTrue(deep, {"a", "b", "c"}));
  CHECK_FALSE(IsTrue(Json::array(), {"a"}));
}

TEST_CASE("Edits are written as LSP has them", "[lsp]") {
  const LineTable lines("ab\ncd");
  const Json edit = TextEditJson(lines, {3, 4}, "x");
  CHECK(edit["range"]["start"] == Json({{"line", 1}, {"character", 0}}));
  CHECK(edit["newText"] == "x");
  CHECK(WorkspaceEditJson("u", Json::array({edit}))["changes"]["u"][0] == edit);
  CHECK(MarkdownJson("x") == Json({{"kind", "markdown"}, {"value", "x"}}));
}

}  // namespace plsc::lsp
