#include "runtime/compare/difference_text.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("A changed symbol shows what changed in it", "[difference_text]") {
  CHECK(PartChangeText({"A1", {"1", "2"}}, {"A1", {"1", "3"}}) ==
        "A1(1, 2 -> 3)");
  CHECK(PartChangeText({"B", {}}, {"T", {"1"}}) == "B -> T(1)");
}

TEST_CASE("Items are shown with what changed and two symbols around",
          "[difference_text]") {
  ItemChange change;
  change.name = "rule 1 of B";
  change.old_line = 3;
  change.new_line = 4;
  change.before = "rule B -> {";
  change.after = "rule B -> if hot = True then {";
  for (const char* name : {"a", "b", "c", "d", "e", "f", "g"}) {
    const PartContent part{name, {}};
    change.parts.push_back({part, part});
  }
  change.parts[3].after.reset();
  CHECK(ItemChangesText({change}) ==
        "~ rule 1 of B (line 4, was 3)\n    - rule B ->\n"
        "    + rule B -> if hot = True then\n      ...\n"
        "      b\n      c\n    - d\n      e\n      f\n      ...\n");
  DifferenceStyle style;
  style.in_color = true;
  CHECK(ItemChangesText({change}, style).find("\x1b[31m- d\x1b[0m\n") !=
        std::string::npos);
}

TEST_CASE("Items that came, went or moved have their marks",
          "[difference_text]") {
  ItemChange added{ItemChangeKind::kAdded, "let a", 0, 2, "", "let a = 1", {}};
  ItemChange gone{ItemChangeKind::kRemoved, "let a", 2, 0, "let a = 1", "", {}};
  ItemChange moved{ItemChangeKind::kMoved, "rule 2 of B", 5, 4,
                   "rule B -> {",          "rule B -> {", {}};
  CHECK(ItemChangesText({added}) == "+ let a (line 2)\n    + let a = 1\n");
  CHECK(ItemChangesText({gone}) == "- let a (was line 2)\n    - let a = 1\n");
  CHECK(ItemChangesText({moved}) ==
        "> rule 2 of B (line 4, was 5)\n      rule B ->\n");
}

TEST_CASE("Where nothing is sensed the names say all", "[difference_text]") {
  const EnvironmentDifference same{{"any", {"flat"}, {}, {}, true}, {}};
  CHECK(RobotDifferencesText("gecko", {same}) == "gecko in flat: the same\n");
}

TEST_CASE("Environments that differ alike are told together",
          "[difference_text]") {
  const std::vector<Difference> brick{
      {DifferenceKind::kAdded, "module 2", "", ""},
      {DifferenceKind::kMoved, "module 3", "x=1", "x=2"}};
  std::vector<EnvironmentDifference> environments;
  environments.push_back({{"a=0", {"flat", "dry"}, {}, {}}, {}});
  for (int i = 1; i < 7; ++i)
    environments.push_back({{"a=" + std::to_string(i), {}, {}, {}}, brick});
  CHECK(RobotDifferencesText("gecko", environments) ==
        "gecko in flat, dry (a=0): the same\n"
        "gecko in a=1; a=2; a=3; a=4; and 2 more:\n"
        "    + module 2\n    > module 3: x=1 -> x=2\n");
}

}  // namespace
}  // namespace plsc
