#include "runtime/exports/controller_tables.h"

#include <cassert>

#include "runtime/exports/robot_model.h"

namespace plsc {

namespace {

std::size_t JointOf(const RobotModel& model, int module) {
  const auto& hinges = model.assembly.hinges;
  for (std::size_t i = 0; i < hinges.size(); ++i)
    if (hinges[i].module == module) return i;
  assert(false);
  return 0;
}

}  // namespace

ControllerTables TablesOf(const RobotModel& model) {
  ControllerTables tables;
  const Brain& brain = model.phenotype.brain;
  std::vector<std::size_t> places;  // of nodes, each in its table
  for (const Node& node : brain.nodes) {
    if (node.type == NodeType::kInput) {
      places.push_back(tables.inputs.size());
      tables.inputs.push_back("touch_" +
                              ModuleId(model.phenotype.body, node.module));
    } else {
      places.push_back(tables.oscillators.size());
      tables.oscillators.push_back({JointOf(model, node.module), node.amplitude,
                                    node.period, node.phase_offset});
    }
  }
  for (const Connection& one : brain.connections) {
    const auto source = static_cast<std::size_t>(one.source);
    const auto destination = static_cast<std::size_t>(one.destination);
    const bool is_loop = source == destination;
    assert(is_loop || brain.nodes[source].type == NodeType::kInput);
    tables.edges.push_back({is_loop, is_loop ? 0 : places[source],
                            places[destination], one.weight});
  }
  return tables;
}

}  // namespace plsc
