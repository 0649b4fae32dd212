// The reader of strings: which symbol goes to which turtle with which
// arguments. The turtles have tests of their own, and reference_test.cc
// compares 549 whole robots.

#include "runtime/develop/develop.h"

#include <catch2/catch.hpp>

#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

Phenotype Grow(const std::string& production) {
  const Genotype genotype =
      test::Robot("iterations 1\nrule C -> { C " + production + " }\n");
  return *Develop(genotype, Environment{});
}

TEST_CASE("a genotype without rules is a lone core", "[develop]") {
  const auto phenotype = Develop(test::Robot(""), Environment{});
  REQUIRE(phenotype);
  CHECK(phenotype->body.modules.size() == 1);
  CHECK(phenotype->brain.nodes.empty());
}

TEST_CASE("arguments arrive in the paper's order w, a, p, o", "[develop]") {
  const Phenotype robot = Grow("add_left A2(-0.5, 2.0, 3.0, 4.0)");
  REQUIRE(robot.brain.nodes.size() == 1);
  const Node& node = robot.brain.nodes[0];
  CHECK(node.weight == -0.5);
  CHECK(node.amplitude == 2);
  CHECK(node.period == 3);
  CHECK(node.phase_offset == 4);
  CHECK(robot.body.modules[1].type == ModuleType::kHorizontalJoint);
  CHECK(robot.body.modules[1].slot == Slot::kLeft);
}

TEST_CASE("each symbol does what Table 1 says", "[develop]") {
  const std::string base = "add_left A1(0.5, 2.0, 3.0, 4.0) add_front T(0.25) ";
  const auto node = [&](const std::string& command) {
    return Grow(base + command).brain.nodes[0];
  };
  CHECK(node("mutate_amp(0.5)").amplitude == 2.5);
  CHECK(node("mutate_per(0.5)").period == 3.5);
  CHECK(node("mutate_off(0.5)").phase_offset == 4.5);

  const auto edges = [&](const std::string& command) {
    return Grow(base + command).brain.connections;
  };
  REQUIRE(edges("").size() == 1);
  CHECK(edges("")[0].weight == 0.25);
  CHECK(edges("mutate_edge(-0.5)")[0].weight == -0.25);
  REQUIRE(edges("loop(0.75)").size() == 2);
  CHECK(edges("loop(0.75)")[1].weight == 0.75);
  CHECK(edges("add_edge(0.75)").size() == 1);  // exists already

  // A second sensor has no edge to the first joint's neuron until the
  // references meet again.
  const Phenotype moved = Grow(
      "add_left A1(0.5, 2.0, 3.0, 4.0) add_right A2(0.5, 2.0, 3.0, 4.0) "
      "add_front T(0.25) move_ref_N(1, 1) loop(1.0)");
  CHECK(moved.brain.connections.back().source == 0);
}

TEST_CASE("a module that is not expressed brings no node", "[develop]") {
  const Phenotype robot = Grow(
      "A1(0.5, 2.0, 3.0, 4.0) T(0.5) add_left B add_left "
      "A2(0.5, 2.0, 3.0, 4.0)");
  CHECK(robot.body.modules.size() == 2);
  CHECK(robot.brain.nodes.empty());
}

TEST_CASE("huge arguments are no danger", "[develop]") {
  const Phenotype robot = Grow(
      "add_left A1(0.5, 2.0, 3.0, 4.0) add_front T(0.25) "
      "mutate_amp(1e300) mutate_per(-1e300) move_ref_N(2000000000, 1)");
  CHECK(robot.brain.nodes[0].amplitude == 10);
  CHECK(robot.brain.nodes[0].period == 1);
}

TEST_CASE("development is a pure function", "[develop]") {
  const Genotype genotype = test::Robot(
      "sense hot: bool\niterations 3\n"
      "rule C -> { C add_left B move_left }\n"
      "rule B -> if hot = True then { B add_front T(0.5) }\n"
      "rule B -> { B add_right B }\n");
  const Genotype before = genotype;
  const auto first = Develop(genotype, Environment{{1}});
  Develop(genotype, Environment{{0}});
  const auto again = Develop(genotype, Environment{{1}});
  CHECK(genotype == before);
  REQUIRE(first);
  REQUIRE(again);
  CHECK(first->body.modules.size() == again->body.modules.size());
}

TEST_CASE("a genotype whose string outgrows the limit does not develop",
          "[develop]") {
  const Genotype genotype =
      test::Robot("iterations 30\nrule C -> { C B B }\nrule B -> { B B }\n");
  CHECK_FALSE(Develop(genotype, Environment{}));
}

}  // namespace
}  // namespace plsc
