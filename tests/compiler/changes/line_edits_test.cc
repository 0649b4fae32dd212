#include "compiler/changes/line_edits.h"

#include <catch2/catch.hpp>
#include <string>

namespace plsc {
namespace {

std::string ScriptOf(std::string_view from, std::string_view to) {
  std::string script;
  for (const LineEdit edit : FindLineEdits(SplitLines(from), SplitLines(to)))
    script += static_cast<char>(edit);
  return script;
}

TEST_CASE("Lines keep their ends", "[diff]") {
  CHECK(SplitLines("").empty());
  CHECK(SplitLines("a\r\n\nb") == Lines{"a\r\n", "\n", "b"});
}

// UnifiedDiff's tests try random texts.
TEST_CASE("A script says of each line whether it is kept", "[diff]") {
  CHECK(ScriptOf("", "").empty());
  CHECK(ScriptOf("1\n2\n3\n", "1\nx\n3\n") == " -+ ");
  CHECK(ScriptOf("1\n2\n", "2\n3\n") == "- +");
  CHECK(ScriptOf("1", "1\n") == "-+");
}

}  // namespace
}  // namespace plsc
