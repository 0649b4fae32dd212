#include "runtime/compare/body_difference.h"

#include <catch2/catch.hpp>

#include "tests/runtime/develop/grown.h"

namespace plsc {
namespace {

Body BodyOf(const std::string& symbols) {
  return test::GrowProduction(symbols).trace().phenotype.body;
}

std::string BodyMarks(const BodyDifference& difference) {
  std::string text;
  for (const ModuleMark mark : difference.marks)
    text += mark == ModuleMark::kShared ? 's'
            : mark == ModuleMark::kNew  ? 'n'
                                        : 'o';
  return text;
}

TEST_CASE("modules are compared by their place, kind and roll",
          "[body_difference]") {
  struct Row {
    const char* why;
    const char* reference;
    const char* body;
    const char* marks;
    std::vector<int> missing;
  };
  const std::vector<Row> rows = {
      {"the same",
       "add_left B add_front T(1)",
       "add_left B add_front T(1)",
       "sss",
       {}},
      {"in another order",
       "add_left B add_right B",
       "add_right B add_left B",
       "sss",
       {}},
      {"one more", "add_left B", "add_left B add_right B", "ssn", {}},
      {"one less", "add_left B add_right B", "add_right B", "ss", {1}},
      {"another kind", "add_left B", "add_left T(1)", "so", {}},
      // What hangs on another joint is rolled another way.
      {"another roll",
       "add_front A1(0,1,1,1) move_front add_front B",
       "add_front A2(0,1,1,1) move_front add_front B",
       "soo",
       {}},
      {"a lone core", "add_left B move_left add_left B", "", "s", {1, 2}},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const BodyDifference difference =
          CompareBodies(BodyOf(row.reference), BodyOf(row.body));
      CHECK(BodyMarks(difference) == row.marks);
      CHECK(difference.missing == row.missing);
    }
  }
}

TEST_CASE("a place is the way of slots from the core", "[body_difference]") {
  const Body body = BodyOf("add_left B move_left add_right A2(0,1,1,1)");
  CHECK(PlacesOf(body) == std::vector<std::string>{"", "3", "32"});
}

}  // namespace
}  // namespace plsc
