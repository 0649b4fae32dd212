#include "runtime/compare/robot_parts.h"

#include <catch2/catch.hpp>
#include <functional>

#include "tests/runtime/compare/golden_sample.h"

namespace plsc {
namespace {

using Reported = std::vector<std::string>;

Reported CompareSample(const std::function<void(GoldenRobot&)>& change) {
  const GoldenRobot expected = *test::GoldenSample().robot;
  GoldenRobot found = expected;
  change(found);
  std::vector<Difference> differences;
  CompareParts(expected, found, differences);
  Reported lines;
  for (const Difference& difference : differences)
    lines.push_back(Describe(difference));
  return lines;
}

// Gives another id to a module or node, everywhere.
void Rename(GoldenRobot& robot, const std::string& from,
            const std::string& to) {
  const auto rename = [&](std::string& id) {
    if (id == from) id = to;
  };
  for (GoldenModule& module : robot.modules) {
    rename(module.id);
    rename(module.parent);
  }
  for (GoldenNode& node : robot.nodes) {
    rename(node.id);
    rename(node.module);
  }
  for (GoldenEdge& edge : robot.edges) {
    rename(edge.source);
    rename(edge.destination);
  }
}

TEST_CASE("differences of bodies are told by place", "[golden]") {
  struct Row {
    const char* why;
    std::function<void(GoldenRobot&)> change;
    Reported told;
  };
  const std::vector<Row> rows = {
      {"equal", [](GoldenRobot&) {}, {}},
      {"listed in another order",
       [](GoldenRobot& r) { std::swap(r.modules[2], r.modules[4]); },
       {}},
      {"missing",
       [](GoldenRobot& r) { r.modules.erase(r.modules.begin() + 3); },
       {"module 4 (B at x=-2,y=0) missing"}},
      {"added",
       [](GoldenRobot& r) {
         r.modules.push_back(
             {"7", "A1", "2", "left", GoldenCell{-1, 1}, "left", 90});
       },
       {"module 7 (A1 at x=-1,y=1) added"}},
      {"moved",
       [](GoldenRobot& r) {
         r.modules[5] = {"6", "B", "4", "front", GoldenCell{-3, 0}, "left", 0};
       },
       {"module 6 (B) moved: expected x=2,y=0, found x=-3,y=0",
        "facing of module 6 (B at x=2,y=0): expected right, found left"}},
      {"moved and another type: two modules",
       [](GoldenRobot& r) {
         r.modules[5] = {"6", "A1", "4", "front", GoldenCell{-3, 0}, "left", 0};
       },
       {"module 6 (B at x=2,y=0) missing", "module 6 (A1 at x=-3,y=0) added"}},
      {"another type",
       [](GoldenRobot& r) { r.modules[5].type = "A1"; },
       {"type of module 6 at x=2,y=0: expected B, found A1"}},
      {"rolled",
       [](GoldenRobot& r) { r.modules[2].angle_deg = 0; },
       {"angle of module 3 (A1 at x=-1,y=0): expected 90, found 0"}},
      {"turned",
       [](GoldenRobot& r) { r.modules[5].facing = "back"; },
       {"facing of module 6 (B at x=2,y=0): expected right, found back"}},
      {"on another parent",
       [](GoldenRobot& r) { r.modules[5].parent = "2"; },
       {"parent of module 6 (B at x=2,y=0): expected 5 front, found 2 front"}},
      {"a sensor on another side",
       [](GoldenRobot& r) {
         r.modules[6].slot = "left";
         Rename(r, "2s1", "2s3");
       },
       {"module 2s1 (T at front of x=0,y=1) missing",
        "module 2s3 (T at left of x=0,y=1) added"}},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(CompareSample(row.change) == row.told);
    }
  }
}

TEST_CASE("later numbers that move on are one difference", "[golden]") {
  const Reported told = CompareSample([](GoldenRobot& r) {
    Rename(r, "6", "7");
    Rename(r, "5", "6");
    Rename(r, "node2", "node4");
    Rename(r, "node3", "node2");
    Rename(r, "node4", "node3");
    std::swap(r.nodes[1], r.nodes[2]);
    r.modules.push_back(
        {"5", "A1", "2", "left", GoldenCell{-1, 1}, "left", 90});
  });
  CHECK(told == Reported{"module 5 (A1 at x=-1,y=1) added",
                         "numbers of modules: expected 5 6, found 6 7",
                         "numbers of nodes: expected node2 node3, found node3 "
                         "node2"});
}

TEST_CASE("differences of brains are told by node and edge", "[golden]") {
  struct Row {
    const char* why;
    std::function<void(GoldenRobot&)> change;
    Reported told;
  };
  const std::vector<Row> rows = {
      {"amplitude",
       [](GoldenRobot& r) { r.nodes[0].amplitude = 2.5; },
       {"amplitude of node1 (A1 at x=-1,y=0): expected 2, found 2.5"}},
      {"period",
       [](GoldenRobot& r) { r.nodes[1].period = 1; },
       {"period of node2 (A2 at x=1,y=0): expected 5, found 1"}},
      {"phase offset",
       [](GoldenRobot& r) { r.nodes[1].phase_offset = 1; },
       {"phase offset of node2 (A2 at x=1,y=0): expected 6, found 1"}},
      {"weight of a sensor",
       [](GoldenRobot& r) { r.nodes[2].weight = 1; },
       {"weight of node3 (T at front of x=0,y=1): expected 0.75, found 1"}},
      {"type",
       [](GoldenRobot& r) { r.nodes[2].is_oscillator = true; },
       {"type of node3 (T at front of x=0,y=1): expected input, found "
        "oscillator"}},
      {"a node is gone, its module is not",
       [](GoldenRobot& r) {
         r.nodes.erase(r.nodes.begin() + 1);
         r.edges.erase(r.edges.begin() + 1);
       },
       {"node2 (A2 at x=1,y=0) missing", "edge node3->node2 missing"}},
      {"an edge more",
       [](GoldenRobot& r) {
         r.edges.push_back({"node2", "node2", 1});
       },
       {"edge node2->node2 added"}},
      {"a second edge between the same nodes",
       [](GoldenRobot& r) {
         r.edges.push_back({"node3", "node1", 0.5});
       },
       {"edge node3->node1 added"}},
      {"edges in another order",
       [](GoldenRobot& r) { std::swap(r.edges[0], r.edges[1]); },
       {"order of edges: expected as recorded, found another"}},
      {"with its module go node and edges",
       [](GoldenRobot& r) {
         r.modules.erase(r.modules.begin() + 4, r.modules.begin() + 6);
         r.nodes.erase(r.nodes.begin() + 1);
         r.edges.erase(r.edges.begin() + 1);
       },
       {"module 5 (A2 at x=1,y=0) missing", "module 6 (B at x=2,y=0) missing"}},
      {"an edge to a node that is not there",
       [](GoldenRobot& r) { r.edges[2].destination = "node9"; },
       {"edge node1->node1 missing", "edge node1->node9 added"}},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(CompareSample(row.change) == row.told);
    }
  }
}

// Whatever single fact changes, something is told.
TEST_CASE("no change of a robot goes unseen", "[golden]") {
  const GoldenRobot sample = *test::GoldenSample().robot;
  for (std::size_t i = 0; i < sample.modules.size(); ++i) {
    const std::vector<std::function<void(GoldenModule&)>> changes = {
        [](GoldenModule& m) { m.id += "0"; },
        [](GoldenModule& m) { m.type = "X"; },
        [](GoldenModule& m) { m.parent += "9"; },
        [](GoldenModule& m) { m.slot = "back"; },
        [](GoldenModule& m) {
          m.cell = GoldenCell{7, 7};
        },
        [](GoldenModule& m) { m.facing = "somewhere"; },
        [](GoldenModule& m) { m.angle_deg += 90; }};
    for (std::size_t c = 0; c < changes.size(); ++c) {
      INFO("module " << i << ", change " << c);
      CHECK(!CompareSample([&](GoldenRobot& r) {
               changes[c](r.modules[i]);
             }).empty());
    }
    INFO("without module " << i);
    CHECK(!CompareSample([&](GoldenRobot& r) {
             r.modules.erase(r.modules.begin() +
                             static_cast<std::ptrdiff_t>(i));
           }).empty());
  }
}

}  // namespace
}  // namespace plsc
