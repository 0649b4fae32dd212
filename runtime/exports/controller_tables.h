#pragma once

// A developed controller as numbered tables, the form in which it leaves plsc:
// joints in the order of the robot's, oscillators and inputs in order of
// creation, edges in the order in which they are added up.

#include <cstddef>
#include <string>
#include <vector>

namespace plsc {

struct RobotModel;

struct TableOscillator {
  std::size_t joint = 0;  ///< index into RobotModel::joints
  double amplitude = 0;
  double period = 0;        ///< s
  double phase_offset = 0;  ///< in periods
};

/// Onto an oscillator: of an input, or of what it gave itself before.
struct TableEdge {
  bool is_loop = false;
  std::size_t input = 0;  ///< index into ControllerTables::inputs; not of loops
  std::size_t oscillator = 0;  ///< index into ControllerTables::oscillators
  double weight = 0;
};

struct ControllerTables {
  std::vector<std::string> inputs;  ///< names of touch sensors
  std::vector<TableOscillator> oscillators;
  std::vector<TableEdge> edges;
};

ControllerTables TablesOf(const RobotModel& model);

}  // namespace plsc
