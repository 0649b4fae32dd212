#include "runtime/pictures/brain_svg.h"

#include "tests/runtime/develop/grown.h"
#include "tests/runtime/pictures/count.h"

namespace plsc {
namespace {

using test::Count;

Phenotype Robot(const std::string& symbols) {
  return test::GrowProduction(symbols).trace().phenotype;
}

TEST_CASE("every node and edge is drawn, its sign as colour and dashes",
          "[brain_svg]") {
  const Phenotype robot = Robot(
      "add_left T(0.5) add_front A1(-0.7,1.6,6.4,2.3) loop(-1) loop(0.5)");
  REQUIRE(robot.brain.nodes.size() == 2);
  REQUIRE(robot.brain.connections.size() == 2);
  const std::string svg = BrainsSvg("robot", {{"flat", "", robot}});
  CHECK(Count(svg, R"(class="node")") == 2);
  CHECK(Count(svg, ">node1-node2 ") == 1);
  CHECK(Count(svg, ">node2-node2 -1.00<") == 1);
  CHECK(Count(svg, "amplitude 1.60, period 6.40 s") == 1);
  CHECK(Count(svg, "phase offset 2.30, w -0.70") == 1);
  CHECK(Count(svg, R"(stroke="#d55e00" stroke-width="6.50" )"
                   R"(stroke-dasharray)") == 1);
  CHECK(Count(svg, ">1s3<") == 1);  // the sensor's id
  CHECK(Count(svg, R"(class="weight")") == 2);
}

TEST_CASE("several environments stand side by side", "[brain_svg]") {
  const std::string svg =
      BrainsSvg("robot", {{"<flat>", "hot=False", Robot("")},
                          {"hot", "hot=True", Robot("add_left T(1)")}});
  CHECK(Count(svg, R"(class="panel")") == 2);
  CHECK(Count(svg, ">&lt;flat&gt;<") == 1);
  CHECK(Count(svg, "no brain") == 1);
  CHECK(Count(svg, ">input of a touch sensor<") == 1);
  CHECK(Count(svg, ">oscillator that drives a joint<") == 0);
  CHECK(Count(svg, ">positive weight<") == 0);
}

TEST_CASE("what is not as in the first environment is marked", "[brain_svg]") {
  const Phenotype first =
      Robot("add_left T(0.5) add_front A1(-0.7,1.6,6.4,2.3) loop(-1)");
  const Phenotype other =
      Robot("add_left T(0.5) add_front A1(-0.7,1.6,6.4,2) add_right T(0.5)");
  const std::string svg =
      BrainsSvg("robot", {{"flat", "", first}, {"hill", "", other}});
  // The new sensor's node and edge, the joint's other phase, and the legend.
  CHECK(Count(svg, R"(class="mark")") == 3 + 2);
  CHECK(Count(svg, R"(class="mark" stroke-dasharray)") == 1 + 1);
  CHECK(Count(svg, ">not there in flat<") == 1);
  CHECK(Count(svg, ">other numbers than in flat<") == 1);
  CHECK(Count(svg, ">only in flat: loop of A1 2, -1.00<") == 1);
  const std::string same =
      BrainsSvg("robot", {{"flat", "", first}, {"hill", "", first}});
  CHECK(Count(same, R"(class="mark")") == 0);
  CHECK(Count(same, "only in") == 0);
}

TEST_CASE("a brain of many edges has them without labels", "[brain_svg]") {
  // Six joints and two sensors, then edges from each sensor to each joint; more
  // than fit.
  std::string symbols = "add_left T(0.5) add_right T(0.5)";
  for (int i = 0; i < 20; ++i)
    symbols += " add_front A2(0.5,1,1,1) move_front loop(0.5)";
  const Phenotype robot = Robot(symbols);
  REQUIRE(robot.brain.connections.size() > 24);
  const std::string svg = BrainsSvg("robot", {{"flat", "", robot}});
  CHECK(Count(svg, R"(class="weight")") == 0);
  CHECK(Count(svg, "<path") == robot.brain.connections.size());
}

}  // namespace
}  // namespace plsc
