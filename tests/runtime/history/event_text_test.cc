#include "runtime/history/event_text.h"

#include "tests/runtime/develop/grown.h"

namespace plsc {
namespace {

// The sentence of the last symbol of the production.
std::string Last(const std::string& production,
                 const std::string& settings = "") {
  const auto grown = test::GrowProduction(production, settings);
  return EventText(grown.view(),
                   static_cast<StringIndex>(grown.trace().events.size() - 1));
}

TEST_CASE("each symbol is told in one sentence", "[event_text]") {
  const std::string nodes = "add_left A1(1,2,3,4) add_right T(0.5) ";
  struct Row {
    std::string production;
    const char* sentence;
  };
  const std::vector<Row> rows = {
      {"", "the core, where both turtles start"},
      {"add_left B",
       "mounted as module 2 (B) at the left of module 1 (C) by add_left "
       "(symbol 2)"},
      {"add_left A1(1,1,1,1) move_left add_left B",
       "mounted as module 3 (B) at the front of module 2 (A1) by add_left "
       "(symbol 5), as a joint has no other side"},
      {"add_left B add_right B add_front B add_right B",
       "mounted as module 5 (B) at the back of module 1 (C) by add_right "
       "(symbol 8), as the core's other sides are taken"},
      {"add_left A1(1,1,1,1) add_right A2(1,1,1,1) add_front T(1)",
       "mounted as sensor 1s1 (T) at the front of module 1 (C) by add_front "
       "(symbol 6); made node3 and node3-node1, node3-node2"},
      {"add_left B move_left", "module-reference moved to module 2 (B)"},
      {nodes + "move_ref_N(1, 1)", "neuron-reference came back to node1"},
      {"add_left A1(1,1,1,1) add_right A2(1,1,1,1) add_front T(1) "
       "move_ref_N(1, 1)",
       "neuron-reference moved from node2 to node1"},
      {nodes + "loop(1)", "made loop node1-node1"},
      {nodes + "mutate_edge(1)", "weight of node2-node1 from 0.5 to 1"},
      {nodes + "mutate_amp(0.5)", "amplitude of node1 from 2 to 2.5"},
      {nodes + "mutate_per(0.5)", "period of node1 from 3 to 3.5"},
      {nodes + "mutate_off(-9)", "phase offset of node1 from 4 to 1"},
      {"B", "not expressed (IV): slot-reference empty"},
      {"add_left", "not expressed (II): no module used the command"},
      {"add_left B add_left B",
       "not expressed (IV): the left of module 1 (C) is taken by module 2 "
       "(B), command kept"},
      {"add_left B add_front B move_front add_left B move_left add_left B",
       "not expressed (IV): the cell at the left of module 4 (B) is taken by "
       "module 2 (B), command kept"},
      {"add_left A1(1,1,1,1) move_left add_left T(1)",
       "not expressed (IV): sensor on a joint, module 2 (A1), command kept"},
      {"move_left",
       "not expressed (V): nothing to move to at the left of module 1 (C)"},
      {"add_left T(1) move_left",
       "not expressed (V): sensor 1s3 (T) at the left of module 1 (C) cannot "
       "be moved to"},
      {"move_back", "not expressed (V): already where the way began"},
      {"move_ref_I(1, 1)", "not expressed (VI): neither input nor neuron yet"},
      {"add_left A1(1,1,1,1) add_edge(1)", "not expressed (VII): no input yet"},
      {nodes + "add_edge(1)", "not expressed (VII): node2-node1 exists"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.production) {
      CHECK(Last(row.production) == row.sentence);
    }
  }
  CHECK(Last("add_left B", "max_modules 1") ==
        "not expressed (IV): limit of 1 modules reached, command kept");
}

TEST_CASE("a mounting command tells who used or overwrote it", "[event_text]") {
  const auto grown = test::GrowProduction("add_left add_front B");
  CHECK(EventText(grown.view(), 1) ==
        "not expressed (II): command overwritten before use, by add_front "
        "(symbol 3)");
  CHECK(EventText(grown.view(), 2) ==
        "slot-reference := front, used by B (symbol 4)");
}

}  // namespace
}  // namespace plsc
