#include "runtime/pictures/brain_text.h"

#include "tests/runtime/develop/grown.h"

namespace plsc {
namespace {

TEST_CASE("a brain is told node by node, edge by edge", "[brain_text]") {
  const Phenotype robot =
      test::GrowProduction(
          "add_left T(0.5) add_front A1(-0.7,1.6,6.4,2.3) loop(-1)")
          .trace()
          .phenotype;
  CHECK(BrainText(robot) ==
        "T 1s3    → ( node1 )\n"
        "( node2 ) → A1 2   a 1.60, p 6.40 s, o 2.30\n"
        "  node1 → node2   -0.70 ╌╌╌╌╌╌╌\n"
        "  node2 ↺         -1.00 ╌╌╌╌╌╌╌╌╌╌\n");
}

TEST_CASE("a brain is told beside another one", "[brain_text]") {
  const Phenotype first =
      test::GrowProduction(
          "add_left T(0.5) add_front A1(-0.7,1.6,6.4,2.3) loop(-1)")
          .trace()
          .phenotype;
  const Phenotype other =
      test::GrowProduction(
          "add_left T(0.5) add_front A1(-0.7,1.6,6.4,2) add_right T(0.5)")
          .trace()
          .phenotype;
  CHECK(BrainText(other, first) ==
        "  T 1s3    → ( node1 )\n"
        "━ T 1s2    → ( node3 )\n"
        "═ ( node2 ) → A1 2   a 1.60, p 6.40 s, o 2.00\n"
        "    node1 → node2   -0.70 ╌╌╌╌╌╌╌\n"
        "━   node3 → node2   +0.50 ━━━━━\n"
        "╌   node2 ↺         -1.00 ╌╌╌╌╌╌╌╌╌╌\n");
  CHECK(BrainText(Phenotype{}, first).find("no brain\n╌ ") !=
        std::string::npos);
}

TEST_CASE("no brain is told too", "[brain_text]") {
  CHECK(BrainText({}) == "no sensor, no joint: no brain\n");
}

}  // namespace
}  // namespace plsc
