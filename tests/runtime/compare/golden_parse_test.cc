#include <catch2/catch.hpp>

#include "runtime/compare/golden_json.h"
#include "tests/runtime/compare/golden_sample.h"

namespace plsc {
namespace {

std::string Read(const std::string& text) {
  const Source source("g.golden.json", text);
  const Result<Golden> golden = ParseGolden(source);
  return golden ? "" : Render(golden.diagnostics(), source);
}

std::string Environments(const std::string& list) {
  return R"({"plsc_golden": 1, "environments": [)" + list + "]}";
}

TEST_CASE("an environment alone is a golden file", "[golden]") {
  const Source source("test", Environments(R"({"environment": "hot=True"})"));
  const Result<Golden> golden = ParseGolden(source);
  REQUIRE(golden);
  REQUIRE(golden->cases.size() == 1);
  CHECK(golden->cases[0].environment == "hot=True");
  CHECK(!golden->cases[0].expected);
  CHECK(golden->descriptor_tolerance == Golden().descriptor_tolerance);
}

TEST_CASE("bad golden files are refused at their place", "[golden]") {
  struct Row {
    const char* why;
    std::string text;
    const char* code;
    const char* place;
    const char* message;
  };
  const std::vector<Row> rows = {
      {"nothing", "", "P5013", "1:1", "empty"},
      {"no JSON", "plsc 1", "P5100", "1:1", "not JSON"},
      {"truncated", R"({"plsc_golden": 1, "env)", "P5100", "1:24",
       "missing closing quote"},
      {"a second value", "{} {}", "P5100", "1:4", "not JSON"},
      {"not UTF-8", "{\"plsc_golden\": \"\xff\"}", "P5011", "1:18", "0xFF"},
      {"a merge conflict", "{\n<<<<<<< mine\n", "P5010", "2:1", "conflict"},
      {"a list", "[]", "P5103", "1:1", "an object"},
      {"no version", R"({"environments": []})", "P5106", "1:1",
       "'plsc_golden' is missing"},
      {"a newer version", R"({"plsc_golden": 2, "robots": []})", "P5002",
       "1:17", "version 2"},
      {"version 0", R"({"plsc_golden": 0})", "P5104", "1:17", "whole number"},
      {"a huge version", R"({"plsc_golden": 18446744073709551615})", "P5104",
       "1:17", "whole number"},
      {"a number beyond doubles", R"({"plsc_golden": 1e999})", "P5100", "1:1",
       "overflow"},
      {"no environment", Environments(""), "P5108", "1:1", "no environment"},
      {"unknown key", R"({"plsc_golden": 1, "enviroments": []})", "P5101",
       "1:20", "did you mean 'environments'"},
      {"unknown key inside", Environments(R"({"environment": "a", "bdy": []})"),
       "P5101", "1:58", "did you mean 'body'"},
      {"a module of nothing",
       Environments(R"({"environment": "a", "body": [{"id": "2", "type": "B",)"
                    R"( "parent": "", "slot": "left", "angle": 0}]})"),
       "P5108", "1:67", "the id of a module"},
      {"a key twice", R"({"plsc_golden": 1, "plsc_golden": 1})", "P5102",
       "1:20", "twice"},
      {"an environment twice",
       Environments("{\"environment\": \"a\"},\n{\"environment\": \"a\"}"),
       "P5108", "2:1", "'a' stands twice"},
      {"no name", Environments(R"({"active_rules": []})"), "P5106", "1:37",
       "'environment' is missing"},
      {"a number as name", Environments(R"({"environment": 3})"), "P5103",
       "1:53", "expected a text for 'environment', found 3"},
      {"a part alone",
       Environments(R"({"environment": "a", "active_rules": []})"), "P5106",
       "1:37", "'string' is missing"},
      {"rule 0", Environments(R"({"environment": "a", "active_rules": [0]})"),
       "P5104", "1:75", "in 'active_rules', found 0"},
      {"half a body",
       Environments(R"({"environment": "a", "active_rules": [], "string": [],
"body": []})"),
       "P5106", "1:37", "'nodes' is missing"},
      {"negative tolerance",
       R"({"plsc_golden": 1, "descriptor_tolerance": -1, "environments": []})",
       "P5104", "1:44", "0 or more"},
      {"another type of node",
       Environments(R"({"environment": "a", "nodes": [{"type": "CPG"}]})"),
       "P5107", "1:68", "found 'CPG'"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const std::string told = Read(row.text);
      INFO(told);
      CHECK(told.find(std::string("error[") + row.code + "]") !=
            std::string::npos);
      CHECK(told.find(std::string("g.golden.json:") + row.place + "\n") !=
            std::string::npos);
      CHECK(told.find(row.message) != std::string::npos);
    }
  }
}

TEST_CASE("a version that is newer is all that is told", "[golden]") {
  const std::string told =
      Read(R"({"plsc_golden": 7, "new": 1, "things": [], "environments": 3})");
  CHECK(told.find("P5101") == std::string::npos);
  CHECK(told.find("version 7") != std::string::npos);
}

TEST_CASE("every truncation of a golden file is an error, not a crash",
          "[golden]") {
  Golden golden;
  golden.cases.push_back({"tilted", test::GoldenSample()});
  const std::string text = PrintGolden(golden);
  // Without the last bracket and line end it is not whole.
  for (std::size_t length = 0; length + 2 < text.size(); ++length)
    if (Read(text.substr(0, length)).empty()) FAIL("accepted at " << length);
}

}  // namespace
}  // namespace plsc
