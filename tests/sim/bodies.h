#pragma once

// Bodies built by hand, for tests and benchmarks of the simulator. They need
// not be reachable by development; angles follow its rule.

#include <string>

#include "sim/phenotype.h"

namespace plsc {

/// A core alone.
inline Body LoneCore() {
  Body body;
  body.modules.emplace_back();
  body.modules[0].number = 1;
  return body;
}

/// Roll of a module against its parent, so that each joint's axis is as its
/// type says and all else is upright (authors' program, plasticoding.py:448).
inline int RollOn(ModuleType parent, ModuleType child) {
  const bool is_rolled = parent == ModuleType::kVerticalJoint;
  const bool is_rolling = child == ModuleType::kVerticalJoint;
  if (is_rolled == is_rolling) return 0;
  return is_rolling ? 90 : 270;
}

/// Mounts a module and gives its index.
inline int Mount(Body& body, int parent, Slot slot, ModuleType type) {
  const int index = static_cast<int>(body.modules.size());
  Module& above = body.modules[static_cast<std::size_t>(parent)];
  Module module;
  module.type = type;
  module.parent = parent;
  module.slot = slot;
  module.angle_deg = RollOn(above.type, type);
  module.number = type == ModuleType::kTouchSensor ? 0 : index + 1;
  above.children[static_cast<std::size_t>(slot)] = index;
  body.modules.push_back(module);
  return index;
}

/// Gives every joint an oscillator; phases a quarter apart, in mounting order.
inline Phenotype WithOscillators(Body body, double amplitude, double period) {
  Phenotype robot{std::move(body), {}};
  for (std::size_t i = 0; i < robot.body.modules.size(); ++i) {
    if (!IsJoint(robot.body.modules[i].type)) continue;
    Node node;
    node.type = NodeType::kOscillator;
    node.module = static_cast<int>(i);
    node.weight = 0.5;
    node.amplitude = amplitude;
    node.period = period;
    node.phase_offset =
        0.25 * static_cast<double>(robot.brain.nodes.size() % 4);
    robot.brain.nodes.push_back(node);
  }
  return robot;
}

/// A horizontal joint that carries a brick on each of the core's four sides:
/// nine modules, a cross that can lift its legs.
inline Body Cross() {
  Body body = LoneCore();
  for (const Slot slot :
       {Slot::kFront, Slot::kRight, Slot::kBack, Slot::kLeft}) {
    const int joint = Mount(body, 0, slot, ModuleType::kHorizontalJoint);
    Mount(body, joint, Slot::kFront, ModuleType::kBrick);
  }
  return body;
}

/// A comb: a chain of bricks, each with a joint to its left, two modules a
/// pair.
inline Body Comb(int pairs) {
  Body body = LoneCore();
  int end = 0;
  for (int i = 0; i < pairs; ++i) {
    end = Mount(body, end, Slot::kFront, ModuleType::kBrick);
    Mount(body, end, Slot::kLeft, ModuleType::kHorizontalJoint);
  }
  return body;
}

}  // namespace plsc
