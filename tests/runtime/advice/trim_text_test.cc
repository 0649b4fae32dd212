#include "runtime/advice/trim_text.h"

#include <algorithm>
#include <catch2/catch.hpp>

namespace plsc {
namespace {

const std::string kTrimHead =
    "plsc 1\nalphabet plasticoding 1\nsense a: bool\nsense b: bool\n";

// Without the pieces whose text is one of `out`.
std::string Without(const std::string& rest,
                    const std::vector<std::string>& out) {
  const Source source("test", kTrimHead + rest);
  const auto mapped = CompileWithMap(source);
  REQUIRE(mapped);
  const Pieces pieces = PiecesOf({&*mapped, 1});
  Kept kept;
  std::size_t found = 0;
  for (const Piece& piece : pieces.all) {
    const std::string text(source.text().substr(
        piece.span.begin, piece.span.end - piece.span.begin));
    const bool is_out = std::find(out.begin(), out.end(), text) != out.end();
    found += is_out ? 1 : 0;
    kept.push_back(!is_out);
  }
  CHECK(found >= out.size());
  const std::string text = KeepText(source, {&*mapped, 1}, pieces, kept);
  CHECK(Compile(Source("after", text)));
  return text.substr(kTrimHead.size());
}

TEST_CASE("Text without its pieces is what a hand would leave", "[trim_text]") {
  struct Row {
    const char* why;
    const char* text;
    std::vector<std::string> out;
    const char* left;
  };
  const std::vector<Row> rows = {
      {"nothing", "rule C -> {C\tB }", {}, "rule C -> {C\tB }"},
      {"a symbol of a line",
       "rule C -> { C B  T(1) }",
       {"B"},
       "rule C -> { C T(1) }"},
      {"symbols without blanks",
       "rule C -> {C T(1)T(0.2)T(0.3)}",
       {"T(0.2)"},
       "rule C -> {C T(1)T(0.3)}"},
      {"the last of a line",
       "rule C -> {\n  C B\n}\n",
       {"B"},
       "rule C -> {\n  C\n}\n"},
      {"a line with its remark",
       "rule C -> {\n  C\n  B # a brick\n}\n",
       {"B"},
       "rule C -> {\n  C\n}\n"},
      {"a remark of its own stays",
       "rule C -> {\n  C\n  # soon\n  B\n}\n",
       {"B"},
       "rule C -> {\n  C\n  # soon\n}\n"},
      {"Windows",
       "rule C -> {\r\n  C B\r\n  T(1)\r\n}\r\n",
       {"B", "T(1)"},
       "rule C -> {\r\n  C\r\n}\r\n"},
      {"a rule and what is said right above it",
       "rule C -> { C }\n\n# far\n\n  # near\nrule B -> { B }\n\nrule T -> { B "
       "}",
       {"rule B -> { B }"},
       "rule C -> { C }\n\n# far\n\nrule T -> { B }"},
      {"what is said to the linter stays",
       "# plsc: allow-file W3003\nrule B -> { T(1) }\nrule C -> { C }",
       {"rule B -> { T(1) }"},
       "# plsc: allow-file W3003\nrule C -> { C }"},
      {"one of two rules of a line",
       "rule B -> { B } rule C -> { C }",
       {"rule B -> { B }"},
       "rule C -> { C }"},
      {"a clause",
       "rule C -> if # if\n a = True # then\n then { C }",
       {"a = True"},
       "rule C -> { C }"},
      {"a clause on a line of its own",
       "rule C ->\n  if a = True\n  then {\n  C\n}\n",
       {"a = True"},
       "rule C ->\n  {\n  C\n}\n"},
      {"the first term",
       "rule C -> if a = True or b = True then { C }",
       {"a = True"},
       "rule C -> if b = True then { C }"},
      {"the last term",
       "rule C -> if a = True or b = True then { C }",
       {"b = True"},
       "rule C -> if a = True then { C }"},
      {"a term of a group",
       "rule C -> if a = True or b = True and b = False then { C }",
       {"b = True"},
       "rule C -> if a = True or b = False then { C }"},
      {"a group in the middle",
       "rule C -> if a = True and b = True or b = False then { C }",
       {"b = True"},
       "rule C -> if a = True or b = False then { C }"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(Without(row.text, row.out) == row.left);
    }
  }
}

}  // namespace
}  // namespace plsc
