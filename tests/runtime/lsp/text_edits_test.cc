#include "runtime/lsp/text_edits.h"

#include <catch2/catch.hpp>
#include <vector>

#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

TEST_CASE("An edit to another text makes that text", "[lsp]") {
  const std::vector<std::string> texts = {
      "",          "a",      "a\n",    "a\nb\n",
      "b\na\n",    "a\na\n", "a\r\nb", "a\nb\nc\nd\n",
      "a\nX\nd\n", "\n\n",   "ab\nb",  "a\nb\nb\n"};
  for (const std::string& from : texts)
    for (const std::string& to : texts) {
      INFO(from << "->" << to);
      const Analysis analysis(kTestUri, from);
      CHECK(Edited(from, EditsTo(analysis, to)) == to);
    }
}

TEST_CASE("What is the same around a change is left alone", "[lsp]") {
  const Analysis analysis(kTestUri, "a\nb\nc\nd\n");
  const Json edits = EditsTo(analysis, "a\nB\nc\nd\n");
  REQUIRE(edits.size() == 1);
  CHECK(edits[0]["newText"] == "B\n");
  CHECK(edits[0]["range"]["start"]["line"] == 1);
  CHECK(edits[0]["range"]["end"]["line"] == 2);
  CHECK(EditsTo(analysis, analysis.text()).empty());
}

}  // namespace plsc::lsp
