#include "runtime/history/provenance_text.h"

#include "tests/runtime/develop/grown.h"

namespace plsc {
namespace {

TEST_CASE("a part is told by what made and what changed it",
          "[provenance_text]") {
  const auto grown = test::Grow(test::kTwoGenerations, Environment{{0}});
  const auto found = HistoryOf(grown.trace(), {PartKind::kNode, "node1"});
  REQUIRE(found);
  const std::string text = PartText(grown.view(), *found);
  CHECK(text.starts_with(
      "symbol 4 of 5, A1: mounted as module 2 (A1) at the front of module 1 "
      "(C) by add_front (symbol 3); made node1\n --> robot.pls:5:23\n"));
  CHECK(text.find("changed by symbol 5 of 5, mutate_amp: amplitude of node1 "
                  "from 2 to 3\n --> robot.pls:5:40\n") != std::string::npos);
}

TEST_CASE("each occurrence of a symbol has its line", "[provenance_text]") {
  const auto grown = test::Grow(test::kTwoGenerations, Environment{{0}});
  CHECK(FatesText(grown.view(), {0, 1}) ==
        "  inserted in iteration 1 for C; replaced in iteration 2\n"
        "  inserted in iteration 2 for C < C; symbol 2 of 5: not expressed "
        "(IV): slot-reference empty\n");
}

TEST_CASE("a symbol that never is in a string says why", "[provenance_text]") {
  const auto cold = test::Grow(test::kTwoGenerations, Environment{{0}});
  CHECK(FatesText(cold.view(), {1, 2}) ==
        "  rule 2 (C, if hot = True) is not active\n");
  CHECK(FatesText(cold.view(), {3, 0}) ==
        "  no rewriting meets a T, so rule 4 (T, if hot = False) is never "
        "used\n");
  const auto hot = test::Grow(test::kTwoGenerations, Environment{{1}});
  CHECK(FatesText(hot.view(), {1, 0}) ==
        "  left out, as the first active rule of C brings the core\n");
  CHECK(OccurrenceAt(hot.view().genotype, {1, 2}).symbol == plasticoding::kT);
}

TEST_CASE("kinds of parts have names", "[provenance_text]") {
  CHECK(KindName(PartKind::kModule) == "module");
  CHECK(KindName(PartKind::kNode) == "node");
  CHECK(KindName(PartKind::kEdge) == "edge");
}

}  // namespace
}  // namespace plsc
