#include "runtime/pictures/body_shapes.h"

#include "tests/runtime/develop/grown.h"
#include "tests/runtime/pictures/count.h"

namespace plsc {
namespace {

using test::Count;

Body BodyOf(const std::string& symbols) {
  return test::GrowProduction(symbols).trace().phenotype.body;
}

TEST_CASE("modules are drawn where they are, sensors inside their parents",
          "[body_shapes]") {
  const Body body = BodyOf("add_left B add_front T(1)");
  const std::string svg = BodyShapes(body, PaintByType(body));
  CHECK(Count(svg, R"(<rect x="-50" y="-50" width="100" height="100" )"
                   R"(fill="#ffe135")") == 1);
  CHECK(Count(svg, R"(<rect x="-150" y="-50" width="100")") == 1);
  CHECK(Count(svg, R"(<circle cx="-50" cy="0" r="8"/>)") == 1);
  CHECK(Count(svg, R"(<rect x="-25" y="-45" width="50" height="10")") == 1);
  CHECK(Count(svg, R"(class="note")") == 0);
}

TEST_CASE("a module is painted as asked, notes are text", "[body_shapes]") {
  const Body body = BodyOf("");
  const std::string svg = BodyShapes(body, {{"#123456", "#fff", "<rule>"}});
  CHECK(Count(svg, R"(fill="#123456")") == 1);
  CHECK(Count(svg, R"(class="note" fill="#fff">&lt;rule&gt;<)") == 1);
}

TEST_CASE("each difference has its outline", "[body_shapes]") {
  struct Row {
    const char* why;
    const char* reference;
    const char* body;
    std::size_t solid;
    std::size_t dashed;
    std::size_t dotted;
  };
  const std::vector<Row> rows = {
      {"none", "add_left B", "add_left B", 0, 0, 0},
      {"new", "", "add_left B add_front T(1)", 2, 0, 0},
      {"other", "add_left B", "add_left A1(0,1,1,1)", 0, 1, 0},
      {"missing", "add_left B add_front T(1)", "", 0, 0, 2},
      // Left of front and front of left are the same cell.
      {"missing, the cell taken", "add_front B move_front add_left B",
       "add_left B move_left add_right B", 2, 0, 1},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const Body reference = BodyOf(row.reference);
      const Body body = BodyOf(row.body);
      const std::string svg =
          DifferenceShapes(reference, body, CompareBodies(reference, body));
      const std::size_t dashed = Count(svg, R"(class="mark" stroke-dasharray)");
      CHECK(dashed == row.dashed);
      CHECK(Count(svg, R"(class="mark")") - dashed == row.solid);
      CHECK(Count(svg, R"(class="missing")") == row.dotted);
    }
  }
}

TEST_CASE("outlines lie below dots", "[body_shapes]") {
  const Body body = BodyOf("add_left B");
  const std::string svg = BodyShapes(body, PaintByType(body), "<outline/>");
  CHECK(svg.find("<outline/>") < svg.find("<circle"));
  CHECK(svg.find("<outline/>") > svg.rfind("<text"));
}

TEST_CASE("an extent has all bodies, and the core's cell", "[body_shapes]") {
  CellExtent extent;
  extent.Include(BodyOf("add_left B move_left add_front B"));
  extent.Include(BodyOf("add_front B add_right T(1)"));
  CHECK(extent.left == -2);
  CHECK(extent.right == 0);
  CHECK(extent.front == 1);
  CHECK(extent.columns() == 3);
  CHECK(extent.rows() == 2);
}

}  // namespace
}  // namespace plsc
