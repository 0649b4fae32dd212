#include "runtime/pictures/body_svg.h"

#include <catch2/catch.hpp>

#include "runtime/develop/body_turtle.h"
#include "tests/runtime/pictures/count.h"

namespace plsc {
namespace {

TEST_CASE("every module of a body is drawn once", "[body_svg]") {
  BodyTurtle turtle(15, false);
  turtle.SetSlot(Slot::kLeft);
  REQUIRE(turtle.Mount(ModuleType::kBrick));
  turtle.SetSlot(Slot::kFront);
  REQUIRE(turtle.Mount(ModuleType::kTouchSensor));
  const std::string svg = BodySvg(turtle.body(), "two modules");
  // Background, two modules, a sensor; one dot; two names and two numbers.
  CHECK(test::Count(svg, "<rect") == 4);
  CHECK(test::Count(svg, "<circle") == 1);
  CHECK(test::Count(svg, "class=\"name\"") == 2);
  CHECK(test::Count(svg, ">two modules<") == 2);
  CHECK(svg.substr(0, 4) == "<svg");
  CHECK(svg.substr(svg.size() - 7) == "</svg>\n");
}

TEST_CASE("a title is shown as text, whatever it holds", "[body_svg]") {
  const std::string svg =
      BodySvg(BodyTurtle(15, false).body(), "</svg><script>&\"\x01");
  CHECK(test::Count(svg, "<script") == 0);
  CHECK(test::Count(svg, "&lt;/svg&gt;&lt;script&gt;&amp;&quot;") == 2);
  CHECK(test::Count(svg, "\x01") == 0);
}

}  // namespace
}  // namespace plsc
