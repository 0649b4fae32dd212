#include "runtime/lsp/completion.h"

#include <catch2/catch.hpp>

#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

namespace {

const char* const kHeader =
    "plsc 1\nalphabet plasticoding 1\nsense hot: bool\n"
    "sense warmth: real in 0..10\nsense ground: { dry, wet }\nlet mild = 5\n"
    "environment flat { hot = False, warmth = 3, ground = dry }\n";

Json Items(const std::string& with_mark, bool has_snippets = false) {
  const Marked marked(kHeader + with_mark);
  Analysis analysis(kTestUri, marked.text);
  return Completion(analysis, marked.offset, has_snippets);
}

std::string Labels(const Json& items) {
  std::string labels;
  for (const Json& item : items)
    labels += (labels.empty() ? "" : " ") + item["label"].get<std::string>();
  return labels;
}

}  // namespace

TEST_CASE("Names that may stand at the cursor are offered", "[lsp]") {
  struct Row {
    const char* text;
    const char* labels;
  };
  const std::vector<Row> rows = {
      {"rule @", "C B A1 A2 T"},
      {"rule B -> if @", "hot warmth ground"},
      {"rule B -> if hot @", "= !="},
      {"rule B -> if warmth @", "= != < <= > >="},
      {"rule B -> if hot = @", "True False"},
      {"rule B -> if warmth > @", "mild"},
      {"rule B -> if ground = @", "dry wet"},
      {"rule B -> if hot = True @", "and or then"},
      {"rule B -> @", "if {"},
      {"rule B -> { T(@", "mild"},
      {"environment e { hot = True, @", "warmth ground"},
      {"test t in @", "flat"},
      {"test t -> body C { @", "front left right back"},
      {"test t -> body @", "C B A1 A2 T"},
      {"sense x: @", "bool real in"},
      {"move_to_new @", "True False"},
      {"let x = @", ""},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.text) {
      CHECK(Labels(Items(row.text)) == row.labels);
    }
  }
}

TEST_CASE("All symbols are offered in a production", "[lsp]") {
  const Json items = Items("rule B -> { add@ }", true);
  REQUIRE(items.size() == 20);
  const Json& joint = items[2];
  CHECK(joint["label"] == "A1");
  CHECK(joint["detail"] ==
        "A1(w in -1..1, a in 1..10, p in 1..10, o in 1..10)");
  CHECK(joint["insertTextFormat"] == 2);
  CHECK(joint["textEdit"]["newText"] ==
        "A1(${1:0}, ${2:5.5}, ${3:5.5}, ${4:5.5})");
  // What was typed is replaced.
  const Json& range = joint["textEdit"]["range"];
  CHECK(range["end"]["character"].get<int>() -
            range["start"]["character"].get<int>() ==
        3);
  const Json& step = items[12];
  CHECK(step["textEdit"]["newText"] == "move_ref_I(${1:1}, ${2:1})");
}

TEST_CASE("Clients without snippets get plain words", "[lsp]") {
  for (const char* text : {"rule B -> { @", "@"})
    for (const Json& item : Items(text, false)) {
      CHECK_FALSE(item.contains("insertTextFormat"));
      CHECK(item["textEdit"]["newText"] == item["label"]);
    }
}

TEST_CASE("Own alphabets are offered", "[lsp]") {
  const Marked marked(
      "plsc 1\nalphabet own { replaceable X(n: int), S; terminal y }\n"
      "axiom S\nrule S -> { @");
  Analysis analysis(kTestUri, marked.text);
  CHECK(Labels(Completion(analysis, marked.offset, true)) == "X S y");
}

}  // namespace plsc::lsp
