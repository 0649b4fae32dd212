#include "runtime/develop/provenance.h"

#include "tests/runtime/develop/grown.h"

namespace plsc {
namespace {

constexpr const char* kRobot =
    "add_left A1(0.5,2,3,4) add_right T(0.25) mutate_edge(0.5) "
    "mutate_amp(1) loop(0.5) mutate_edge(0.125)";

TEST_CASE("a part is found by its id", "[provenance]") {
  const auto grown = test::GrowProduction(kRobot);
  struct Row {
    const char* why;
    PhenotypePart part;
    const char* id;
    StringIndex origin;
    std::vector<StringIndex> changes;
  };
  const std::vector<Row> rows = {
      {"the core", {PartKind::kModule, "1"}, "1", 0, {}},
      {"a joint", {PartKind::kModule, "2"}, "2", 2, {}},
      {"a sensor", {PartKind::kModule, "1s2"}, "1s2", 4, {}},
      {"a neuron", {PartKind::kNode, "node1"}, "node1", 2, {6}},
      {"its number will do", {PartKind::kNode, "2"}, "node2", 4, {}},
      {"an edge", {PartKind::kEdge, "node2-node1"}, "node2-node1", 4, {5, 8}},
      {"its numbers will do",
       {PartKind::kEdge, "2-1"},
       "node2-node1",
       4,
       {5, 8}},
      {"a loop", {PartKind::kEdge, "1-1"}, "node1-node1", 7, {}},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const auto found = HistoryOf(grown.trace(), row.part);
      REQUIRE(found);
      CHECK(found->id == row.id);
      CHECK(found->origin == row.origin);
      CHECK(found->changes == row.changes);
    }
  }
}

TEST_CASE("a part that is not there is none", "[provenance]") {
  const auto grown = test::GrowProduction(kRobot);
  for (const PhenotypePart& part :
       {PhenotypePart{PartKind::kModule, "3"},
        PhenotypePart{PartKind::kModule, ""},
        PhenotypePart{PartKind::kNode, "node3"},
        PhenotypePart{PartKind::kNode, "x"},
        PhenotypePart{PartKind::kEdge, "node1-node2"},
        PhenotypePart{PartKind::kEdge, "1"},
        PhenotypePart{PartKind::kEdge, "1-"}}) {
    INFO(part.id);
    CHECK_FALSE(HistoryOf(grown.trace(), part));
  }
}

TEST_CASE("the ids of all parts are listed", "[provenance]") {
  const auto grown = test::GrowProduction(kRobot);
  const Phenotype& robot = grown.trace().phenotype;
  using Ids = std::vector<std::string>;
  CHECK(IdsOf(robot, PartKind::kModule) == Ids{"1", "2", "1s2"});
  CHECK(IdsOf(robot, PartKind::kNode) == Ids{"node1", "node2"});
  CHECK(IdsOf(robot, PartKind::kEdge) == Ids{"node2-node1", "node1-node1"});
}

TEST_CASE("every insertion of a symbol has its fate", "[provenance]") {
  // Not hot: C B / C B (add_front A1 mutate_amp), where the first iteration's
  // B is replaced and the second's stays.
  const auto grown = test::Grow(test::kTwoGenerations, Environment{{0}});
  const Derivation& derivation = grown.history.derivation;
  const auto bricks = FatesOf(derivation, 0, 1);
  REQUIRE(bricks.size() == 2);
  CHECK(bricks[0].replaced_in == 2);
  CHECK(bricks[0].index == kNoIndex);
  CHECK(bricks[1].index == 1);
  CHECK(derivation[bricks[1].insertion].iteration == 2);
  const auto joints = FatesOf(derivation, 2, 1);
  REQUIRE(joints.size() == 1);
  CHECK(joints[0].index == 3);
  CHECK(FatesOf(derivation, 1, 2).empty());  // needs hot
}

}  // namespace
}  // namespace plsc
