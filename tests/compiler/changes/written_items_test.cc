#include "compiler/changes/written_items.h"

#include <catch2/catch.hpp>

#include "grammar/parse.h"

namespace plsc {
namespace {

constexpr const char* kText = R"(# a file
plsc 1 # the first

sense hot: bool  # warm
# of the core
rule C -> if hot = True and hot != False then { # go
  C
  # a brick
  add_left B   # behind
  A1(0.50, 2.0, 3, 1e0)
  # last
}
environment warm { hot = True, }
test grows in warm -> body C { left B }
# the end
)";

std::string Joined(const WrittenFile& file) {
  std::string text;
  for (const WrittenItem& item : file.items)
    text += item.before + CoreText(item) + item.after;
  return text + file.end;
}

TEST_CASE("Items keep every byte", "[written_items]") {
  const Source source("file", kText);
  CHECK(Joined(ReadItems(source)) == kText);
  const Source windows("file", "plsc 1\r\nlet a = 1 # x\r\nlet b = 2\r\n");
  CHECK(Joined(ReadItems(windows)) == windows.text());
}

TEST_CASE("Comments belong to what they stand before or behind",
          "[written_items]") {
  const Source source("file", kText);
  const WrittenFile file = CutIntoItems(Parse(source).file);
  REQUIRE(file.items.size() == 5);
  CHECK(file.items[0].before == "# a file\n");
  CHECK(file.items[0].after == " # the first");
  CHECK(file.items[1].after == "  # warm");
  const WrittenItem& rule = file.items[2];
  CHECK(rule.before == "\n# of the core\n");
  CHECK(rule.open == "rule C -> if hot = True and hot != False then { # go");
  REQUIRE(rule.parts.size() == 4);
  CHECK(rule.parts[1].before == "\n  # a brick\n  ");
  CHECK(rule.parts[2].after == "   # behind");
  CHECK(rule.close == "\n  # last\n}");
  CHECK(file.end == "\n# the end\n");
}

TEST_CASE("Items know what they are and say", "[written_items]") {
  const Source source("file", kText);
  const WrittenFile file = ReadItems(source);
  CHECK(file.items[1].key == "sense hot");
  const WrittenItem& rule = file.items[2];
  CHECK(rule.key == "rule C");
  CHECK(rule.content == "rule C -> if hot = True and hot != False then {");
  REQUIRE(rule.terms.size() == 2);
  CHECK(rule.terms[1].content == PartContent{"hot", {"and", "!=", "False"}});
  // However its numbers are spelled.
  CHECK(rule.parts[3].content == PartContent{"A1", {"0.5", "2", "3", "1"}});
  CHECK(rule.parts[3].text == "A1(0.50, 2.0, 3, 1e0)");
  CHECK(file.items[3].key == "environment warm");
  CHECK(file.items[3].parts[0].content == PartContent{"hot", {"True"}});
  CHECK(file.items[4].content == "test grows in warm -> body C {\nleft B");
}

TEST_CASE("An empty text has no items", "[written_items]") {
  CHECK(ReadItems(Source("file", "")).items.empty());
  CHECK(ReadItems(Source("file", "\n \n")).items.empty());
}

TEST_CASE("CountGenotypes counts the items", "[written_items]") {
  const Source source("file", "plsc 1\ngenotype a\ngenotype b\n");
  CHECK(CountGenotypes(ReadItems(source)) == 2);
}

TEST_CASE("CommentsIn finds comments without their blanks", "[written_items]") {
  CHECK(CommentsIn("a # b \r\n  # c # d\n") ==
        std::vector<std::string>{"# b", "# c # d"});
  CHECK(CommentsIn("a\n").empty());
}

}  // namespace
}  // namespace plsc
