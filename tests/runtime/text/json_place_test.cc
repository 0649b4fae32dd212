#include "runtime/text/json_place.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

std::string At(const std::string& text, Span span) {
  return text.substr(span.begin, span.end - span.begin);
}

TEST_CASE("JsonPlaceOf finds values by their path", "[json_place]") {
  const std::string text =
      R"( {"a": [1, {"b\"]": "x, y"}, [true]], "c": {"d": -1.5e3}, "e": null})";
  struct Row {
    const char* why;
    std::vector<std::string> path;
    const char* value;
    const char* key;
  };
  const std::vector<Row> rows = {
      {"the root", {}, "{", "{"},
      {"a list", {"a"}, "[", "\"a\""},
      {"an element", {"a", "0"}, "1", "1"},
      {"a bracket in a key", {"a", "1", "b\\\"]"}, "\"x, y\"", "\"b\\\"]\""},
      {"deep", {"a", "2", "0"}, "true", "true"},
      {"a number", {"c", "d"}, "-1.5e3", "\"d\""},
      {"the last", {"e"}, "null", "\"e\""},
      {"no such key: the last that is there", {"c", "x"}, "{", "\"c\""},
      {"no such element", {"a", "7"}, "[", "\"a\""},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(At(text, JsonPlaceOf(text, row.path)) == row.value);
      CHECK(At(text, JsonKeyPlaceOf(text, row.path)) == row.key);
    }
  }
}

TEST_CASE("RepeatedJsonKey finds a key that its object has", "[json_place]") {
  struct Row {
    const char* text;
    std::optional<std::uint32_t> begin;
  };
  const std::vector<Row> rows = {
      {R"({"a": 1, "b": {"a": 1}, "c": [{"a": 1}, {"a": 1}]})", std::nullopt},
      {R"({"a": "a", "b": ["a", "a"]})", std::nullopt},
      {R"({"a": 1, "a": 1})", 9},
      {R"({"a": {"x": 1, "x" : 1}})", 15},
      {R"({"a": {}, "a": 1})", 10},
      {R"(]}{"a)", std::nullopt},
      {"", std::nullopt},
  };
  for (const Row& row : rows) {
    INFO(row.text);
    const auto found = RepeatedJsonKey(row.text);
    CHECK(found.has_value() == row.begin.has_value());
    if (found && row.begin) CHECK(found->begin == *row.begin);
  }
}

}  // namespace
}  // namespace plsc
