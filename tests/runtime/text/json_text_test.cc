#include "runtime/text/json_text.h"

#include <catch2/catch.hpp>
#include <string>

#include "runtime/text/json_place.h"

namespace plsc {
namespace {

// golden_parse_test.cc has more of them, at their places in a file.
TEST_CASE("only one JSON value without repeated keys is read", "[json_text]") {
  struct Row {
    const char* why;
    const char* text;
    const char* code;
  };
  const std::vector<Row> rows = {
      {"an object", R"({"a": {"b": 1}, "b": 2})", ""},
      {"empty", "", "P5013"},
      {"no JSON", "{a: 1}", "P5100"},
      {"two values", "{} {}", "P5100"},
      {"a number beyond doubles", R"({"a": 1e999})", "P5100"},
      {"a key twice", R"({"a": 1, "a": 2})", "P5102"},
      {"no UTF-8", "{\"a\": \"\xff\"}", "P5011"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const auto json = ReadJson(Source("t.json", row.text));
      CHECK((json ? "" : NumberOf(json.diagnostics()[0].code)) == row.code);
    }
  }
}

TEST_CASE("Brackets are not nested without bound", "[json_text]") {
  const auto code = [](std::size_t depth) {
    const auto json = ReadJson(
        Source("t.json", std::string(depth, '[') + std::string(depth, ']')));
    return json ? "" : NumberOf(json.diagnostics()[0].code);
  };
  CHECK(code(kMaxJsonDepth).empty());
  CHECK(code(kMaxJsonDepth + 1) == "P5100");
  CHECK(code(1'000'000) == "P5100");
  CHECK(ReadJson(Source("t.json", "[\"" + std::string(100, '[') + "\"]")));
}

}  // namespace
}  // namespace plsc
