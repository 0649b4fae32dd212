// How often a development asks for memory: never more often because the string
// is longer. A program of its own, as it replaces operator new.

#include <catch2/catch.hpp>

#include "runtime/develop/develop.h"
#include "tests/allocations.h"
#include "tests/runtime/develop/compile_text.h"

namespace plsc {
namespace {

// A small robot with an edge, and `idle` times five commands that may move
// both turtles but grow nothing. C is rewritten too, so all comes three times.
Genotype RobotWithIdle(int idle) {
  std::string rule =
      "rule C -> { C add_left A1(0.5, 2, 3, 4) add_front T(0.25) add_right B";
  for (int i = 0; i < idle; ++i)
    rule +=
        " move_left move_back add_front mutate_edge(0.125) move_ref_N(1, 1)";
  return test::Robot("iterations 3\n" + rule + " }\n");
}

std::size_t AllocationsOf(const Genotype& genotype) {
  const std::size_t before = test::AllocationCount();
  const std::optional<Phenotype> robot = Develop(genotype, Environment{});
  const std::size_t after = test::AllocationCount();
  REQUIRE(robot);
  // Far fewer than the turtles make room for: what grows is the string alone.
  REQUIRE(robot->body.modules.size() == 5);
  REQUIRE(robot->brain.connections.size() == 2);
  return after - before;
}

TEST_CASE("allocations are counted", "[allocation]") {
  const std::size_t before = test::AllocationCount();
  const std::vector<int> one(3);
  CHECK(test::AllocationCount() == before + 1);
}

TEST_CASE("development allocates as often for a long string as for a short one",
          "[allocation]") {
  // Three arrays of active rules, six of the turtles, and the strings: the
  // axiom and one for each rewriting but the last, which is not written.
  constexpr std::size_t kMost = 3 + 6 + 1 + 2;
  const std::size_t few = AllocationsOf(RobotWithIdle(0));
  CHECK(few <= kMost);
  for (const int idle : {1, 10, 100, 1000}) {
    CAPTURE(idle);
    CHECK(AllocationsOf(RobotWithIdle(idle)) == few);
  }
}

}  // namespace
}  // namespace plsc
