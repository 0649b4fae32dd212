#include "runtime/text/json_reader.h"

#include <array>
#include <catch2/catch.hpp>

namespace plsc {
namespace {

constexpr std::array<std::string_view, 3> kKnown{"text", "number", "list"};

TEST_CASE("JsonReader reads values of the right type", "[json_reader]") {
  const Source source("t", R"({"text": "a", "number": 3, "list": [1, 2]})");
  const auto json = nlohmann::json::parse(source.text());
  JsonReader reader(source);
  const JsonValue root{json, nullptr, ""};
  CHECK(reader.IsObject(root, kKnown));
  CHECK(reader.Has(root, "text"));
  CHECK(!reader.Has(root, "test"));
  CHECK(reader.Text(root, "text") == "a");
  CHECK(reader.Number(root, "number") == 3);
  CHECK(reader.Integer(root, "number", 0, 3) == 3);
  std::vector<std::int64_t> list;
  reader.List(root, "list", [&](const JsonValue& value) {
    list.push_back(reader.Integer(value, 0, 9));
  });
  CHECK(list == std::vector<std::int64_t>{1, 2});
  CHECK(reader.errors().empty());
}

TEST_CASE("JsonReader reports what is wrong, at its place", "[json_reader]") {
  const Source source(
      "t", R"({"text": 1, "number": "x", "list": {}, "nmber": [1, -1, 99]})");
  const auto json = nlohmann::json::parse(source.text());
  JsonReader reader(source);
  const JsonValue root{json, nullptr, ""};
  CHECK(reader.IsObject(root, kKnown));
  CHECK(reader.Text(root, "text").empty());
  CHECK(reader.Number(root, "number") == 0);
  reader.List(root, "list", [](const JsonValue&) { FAIL("not a list"); });
  reader.List(root, "nmber", [&](const JsonValue& value) {
    CHECK(reader.Integer(value, 0, 9) <= 9);
  });
  CHECK(reader.Text(root, "missing").empty());
  std::vector<std::string> told;
  for (const Diagnostic& error : reader.errors())
    told.push_back(std::string(NumberOf(error.code)) + "@" +
                   std::to_string(error.span.begin) + " " + error.message);
  CHECK(told == std::vector<std::string>{
                    "P5101@39 unknown key 'nmber'",
                    "P5103@9 expected a text for 'text', found 1",
                    "P5103@22 expected a number for 'number', found \"x\"",
                    "P5103@35 expected a list for 'list', found an object",
                    "P5104@52 expected a whole number in 0..9 in 'nmber', "
                    "found -1",
                    "P5104@56 expected a whole number in 0..9 in 'nmber', "
                    "found 99",
                    "P5106@0 the key 'missing' is missing here"});
}

TEST_CASE("JsonReader stops after a screenful of errors", "[json_reader]") {
  std::string text = "[";
  for (int i = 0; i < 1000; ++i) text += i == 0 ? "1" : ",1";
  const Source source("t", text + "]");
  const auto json = nlohmann::json::parse(source.text());
  JsonReader reader(source);
  const JsonValue root{json, nullptr, ""};
  for (std::size_t i = 0; i < json.size(); ++i)
    CHECK(reader.Text(JsonValue{json[i], &root, std::to_string(i)}).empty());
  CHECK(reader.errors().size() == 20);
}

// Not timed, but a file of 0.2 MB took minutes while a place was looked for
// beyond the last error shown.
TEST_CASE("JsonReader is soon done with a file that is all wrong",
          "[json_reader]") {
  std::string list = "[";
  std::string object = "{";
  for (int i = 0; i < 100000; ++i) {
    list += i == 0 ? "1" : ",1";
    object += (i == 0 ? "\"k" : ",\"k") + std::to_string(i) + "\":1";
  }
  const Source source("t", "{\"list\":" + list + "],\"o\":" + object + "}}");
  const auto json = nlohmann::json::parse(source.text());
  JsonReader reader(source);
  const JsonValue root{json, nullptr, ""};
  const JsonValue inner{json["o"], &root, "o"};
  CHECK_FALSE(reader.IsObject(inner, {}));
  CHECK(reader.errors().size() == 20);
  reader.List(root, "list",
              [&](const JsonValue& value) { reader.Text(value); });
  CHECK(reader.errors().size() == 20);
}

}  // namespace
}  // namespace plsc
