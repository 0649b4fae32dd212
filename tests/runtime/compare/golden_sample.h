#pragma once

// A small robot as a golden file remembers it, for tests that change it.

#include "runtime/compare/golden.h"

namespace plsc::test {

/// The core with a brick before it (with a sensor on its front), and two
/// joints at the sides with a brick each.
inline Observation GoldenSample() {
  GoldenRobot robot;
  robot.modules = {
      {"1", "C", "", "", GoldenCell{0, 0}, "front", 0},
      {"2", "B", "1", "front", GoldenCell{0, 1}, "front", 0},
      {"3", "A1", "1", "left", GoldenCell{-1, 0}, "left", 90},
      {"4", "B", "3", "front", GoldenCell{-2, 0}, "left", 270},
      {"5", "A2", "1", "right", GoldenCell{1, 0}, "right", 0},
      {"6", "B", "5", "front", GoldenCell{2, 0}, "right", 0},
      {"2s1", "T", "2", "front", std::nullopt, "", 0},
  };
  robot.nodes = {
      {"node1", "3", true, 0.5, 2, 3, 1},
      {"node2", "5", true, -0.25, 4, 5, 6},
      {"node3", "2s1", false, 0.75, 0, 0, 0},
  };
  robot.edges = {{"node3", "node1", 0.5},
                 {"node3", "node2", 0.125},
                 {"node1", "node1", -1}};
  robot.body_descriptors = {{"branching", 0.5}, {"width", 5}};
  robot.brain_descriptors = {{"recurrence", 0.25}};
  Observation observation;
  observation.senses = "inclined=True";
  observation.active_rules = {1, 3};
  observation.string.symbols = {"C", "add_front", "B", "T(0.75)"};
  observation.string.length = 4;
  observation.robot = robot;
  return observation;
}

}  // namespace plsc::test
