#include "runtime/develop/trace.h"

#include "tests/runtime/develop/grown.h"

namespace plsc {
namespace {

using test::GrowProduction;

// Effects of the symbols after C, by name.
std::string Effects(const std::string& production,
                    const std::string& settings = "") {
  const auto grown = GrowProduction(production, settings);
  std::string names;
  for (std::size_t i = 1; i < grown.trace().events.size(); ++i) {
    if (i > 1) names += ' ';
    names += InfoOf(grown.trace().events[i].effect).name;
  }
  return names;
}

TEST_CASE("each reason of the paper keeps its symbol from being expressed",
          "[trace]") {
  struct Row {
    const char* why;
    const char* production;
    const char* effects;
    const char* settings = "";
  };
  const std::vector<Row> rows = {
      {"II overwritten", "add_left add_right B",
       "slot_overwritten slot_used mounted"},
      {"II never used", "add_left", "slot_unused"},
      {"IV no command", "B", "no_slot"},
      {"IV slot taken, command kept", "add_left B add_left B move_left B",
       "slot_used mounted slot_used slot_taken module_reached mounted"},
      {"IV slot taken by a sensor", "add_left T(1) add_left B",
       "slot_used mounted slot_unused slot_taken"},
      {"IV cell taken",
       "add_left B add_front B move_front add_left B move_left add_left B",
       "slot_used mounted slot_used mounted module_reached slot_used mounted "
       "module_reached slot_unused cell_taken"},
      {"IV sensor on a joint", "add_left A1(1,1,1,1) move_left add_front T(1)",
       "slot_used mounted module_reached slot_unused sensor_on_joint"},
      {"IV the body is full", "add_left B add_front B",
       "slot_used mounted slot_unused body_full", "max_modules 2"},
      {"V nothing there", "move_left", "side_empty"},
      {"V a sensor there", "add_left T(1) move_left",
       "slot_used mounted sensor_there"},
      {"V at the start", "move_back", "at_start"},
      {"VI and VII nothing yet", "move_ref_I(1,1) loop(1)",
       "no_nodes no_nodes"},
      {"VII no input yet", "add_left A1(1,1,1,1) loop(1)",
       "slot_used mounted no_input"},
      {"VII no neuron yet", "add_left T(1) add_edge(1) mutate_amp(1)",
       "slot_used mounted no_neuron no_neuron"},
      {"VII edge and loop exist",
       "add_left T(1) add_right A1(1,1,1,1) add_edge(1) loop(1) loop(1)",
       "slot_used mounted slot_used mounted edge_exists loop_added "
       "loop_exists"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(Effects(row.production, row.settings) == row.effects);
    }
  }
}

TEST_CASE("an edge between references that never met is missing", "[trace]") {
  // The second sensor (node4) meets the newer neuron (node3) only; then the
  // neuron-reference goes back to the older one (node1).
  CHECK(Effects("add_left A1(1,1,1,1) add_front T(1) add_right A2(1,1,1,1) "
                "add_left T(1) move_ref_N(1, 1) mutate_edge(1) add_edge(1)") ==
        "slot_used mounted slot_used mounted slot_used mounted slot_used "
        "mounted node_reached no_edge edge_added");
}

TEST_CASE("an event names the module in the way", "[trace]") {
  const auto grown = GrowProduction(
      "add_left B add_left T(1) move_left add_right B add_front B");
  const std::vector<Event>& events = grown.trace().events;
  const Event& taken = events[4];
  CHECK(taken.effect == Effect::kSlotTaken);
  CHECK(taken.module == 1);
  CHECK(taken.reference == 0);
  CHECK(taken.slot == Slot::kLeft);
  CHECK(taken.partner == 3);
  const Event& moved = events[5];
  CHECK(moved.effect == Effect::kModuleReached);
  CHECK(moved.module == 1);
  CHECK(events[3].effect == Effect::kSlotOverwritten);
  CHECK(events[3].partner == 6);
}

TEST_CASE("a slot that the command did not name is the one that was used",
          "[trace]") {
  const auto joint =
      GrowProduction("add_left A1(1,1,1,1) move_left add_right B");
  CHECK(joint.trace().events[5].slot == Slot::kFront);
  CHECK(joint.trace().events[4].slot == Slot::kRight);
  const auto core =
      GrowProduction("add_left B add_front B add_right B add_left B");
  CHECK(core.trace().events[8].effect == Effect::kMounted);
  CHECK(core.trace().events[8].slot == Slot::kBack);
}

TEST_CASE("values before and after a change are kept", "[trace]") {
  const auto grown = GrowProduction(
      "add_left A1(0.5,2,3,4) add_right T(0.25) mutate_edge(0.5) "
      "mutate_edge(1) mutate_amp(1) mutate_per(-5) mutate_off(0.5)");
  const std::vector<Event>& events = grown.trace().events;
  struct Row {
    double before;
    double after;
  };
  const std::vector<Row> rows = {
      {0.25, 0.75}, {0.75, 1}, {2, 3}, {3, 1}, {4, 4.5}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CHECK(events[5 + i].before == rows[i].before);
    CHECK(events[5 + i].after == rows[i].after);
  }
  CHECK(events[5].edge == 0);
  CHECK(events[7].node == 0);
}

TEST_CASE("a mounted module is credited with its node and edges", "[trace]") {
  const auto grown = GrowProduction(
      "add_left A1(1,1,1,1) add_right A2(1,1,1,1) add_front T(1)");
  const Trace& trace = grown.trace();
  const Event& sensor = trace.events[6];
  CHECK(sensor.module == 3);
  CHECK(sensor.node == 2);
  CHECK(sensor.edge == 0);
  CHECK(sensor.edge_count == 2);
  CHECK(trace.module_origins == std::vector<StringIndex>{0, 2, 4, 6});
  CHECK(trace.node_origins == std::vector<StringIndex>{2, 4, 6});
  CHECK(trace.edge_origins == std::vector<StringIndex>{6, 6});
}

TEST_CASE("references that move tell from where to where", "[trace]") {
  const auto grown = GrowProduction(
      "add_left A1(1,1,1,1) add_right A2(1,1,1,1) add_front T(1) "
      "move_ref_N(1, 1) move_ref_I(1, 1)");
  const std::vector<Event>& events = grown.trace().events;
  CHECK(events[7].node_before == 1);
  CHECK(events[7].node == 0);
  CHECK(events[8].node_before == 2);
  CHECK(events[8].node == 2);
}

TEST_CASE("other alphabets have a derivation and no trace", "[trace]") {
  const auto grown = test::Grow(
      "plsc 1 alphabet d { replaceable X; terminal a } axiom X iterations 2\n"
      "rule X -> { X a }\n",
      Environment{});
  CHECK_FALSE(grown.history.trace);
  CHECK(grown.history.derivation.string().size() == 3);
}

}  // namespace
}  // namespace plsc
