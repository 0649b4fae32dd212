#include "runtime/text/yaml_text.h"

#include <catch2/catch.hpp>

#include "runtime/text/yaml_reader.h"

namespace plsc {
namespace {

TEST_CASE("Printed texts read back", "[yaml]") {
  for (const std::string text :
       {"plain",      "two words",   "True",        "null",   "5",       "a: b",
        "it's",       "\"x\"",       "no",          "ON",     "1e3",     "0x10",
        "2026-01-01", "~",           "\x7F",        "\u0085", "\uFEFF",  "- a",
        "tab\there",  "line\nbreak", "#no comment", "",       "\xC3\xA4"}) {
    CAPTURE(text);
    const Source source("test.yaml", "key: " + PrintYamlText(text) + "\n");
    const YamlFile file(source);
    auto root = file.Root("a test");
    REQUIRE(root);
    CHECK(root->Find("key")->text() == text);
  }
}

TEST_CASE("Words of YAML are quoted, others are not", "[yaml]") {
  CHECK(PrintYamlText("plastic_2") == "plastic_2");
  CHECK(PrintYamlText("no") == "\"no\"");
  CHECK(PrintYamlText("Null") == "\"Null\"");
  CHECK(PrintYamlText("\x7F\u2028") == "\"\\x7F\\u2028\"");
}

}  // namespace
}  // namespace plsc
