// The paper's Eq. 1 and a servo as the authors' program has it
// (NeuralNetwork.cpp:369-382, PositionMotor.cpp:95-133). In their runs neither
// inputs nor loops reach the output: weighted sums are computed and not used,
// and the weights are never loaded. So kOpenLoop is what was published, and
// kCoupled, which adds them up, is our reading of the paper's prose.
//
// Outputs are a function of time and not of a phase that is carried along:
// after any number of updates there is no drift, and a life that goes on in
// another season swings on where it was. In the coupled mode weights are added
// in the order of the brain's connections, which is thereby part of the result;
// the exported controllers repeat it operation by operation
// (runtime/exports/controller_header) and are compared bit for bit. Whoever
// reorders an expression here changes every stored run.
//
// Nodes times edges an update, eight updates a second.

#include "sim/controller.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "sim/maths/sine.h"

namespace plsc {
double Oscillate(const Node& oscillator, double time) {
  const double turns = time / oscillator.period - oscillator.phase_offset;
  // Whole turns are left out before pi, which is not exact, comes in: a life
  // may be as long as it likes.
  const double part = turns - std::round(turns);
  return 0.5 + oscillator.amplitude / 2 * Sin(2 * std::numbers::pi * part);
}

double ServoSpeed(double output, double angle, const ServoOptions& servo) {
  const double share = std::clamp(output, kMinOutput, kMaxOutput);
  const double target = -servo.range + share * 2 * servo.range;
  return std::clamp(servo.gain * (target - angle), -servo.max_speed,
                    servo.max_speed);
}

Controller::Controller(const Phenotype& phenotype, ControllerMode mode)
    : brain_(phenotype.brain),
      mode_(mode),
      previous_(phenotype.brain.nodes.size(), kRestOutput) {
  std::vector<int> joint_of_module;
  for (const Module& module : phenotype.body.modules)
    joint_of_module.push_back(IsJoint(module.type) ? static_cast<int>(joints_++)
                                                   : kNoModule);
  for (const Node& node : brain_.nodes) {
    const int joint = joint_of_module[static_cast<std::size_t>(node.module)];
    assert(node.type == NodeType::kInput || joint != kNoModule);
    joint_of_node_.push_back(joint);
  }
}

void Controller::Remember(std::vector<double> memory) {
  assert(memory.size() == previous_.size());
  previous_ = std::move(memory);
}

double Controller::Coupled(std::size_t node, double free_output,
                           const std::vector<bool>& touched) const {
  double output = free_output;
  for (const Connection& edge : brain_.connections) {
    if (static_cast<std::size_t>(edge.destination) != node) continue;
    const auto source = static_cast<std::size_t>(edge.source);
    if (source == node) {
      output += edge.weight * (previous_[node] - kRestOutput);
    } else if (touched[static_cast<std::size_t>(brain_.nodes[source].module)]) {
      output += edge.weight;
    }
  }
  return std::clamp(output, 0.0, 1.0);
}

const std::vector<double>& Controller::Update(
    double time, const std::vector<bool>& touched) {
  outputs_.assign(joints_, kRestOutput);
  for (std::size_t i = 0; i < brain_.nodes.size(); ++i) {
    const Node& node = brain_.nodes[i];
    if (node.type != NodeType::kOscillator) continue;
    double output = Oscillate(node, time);
    if (mode_ == ControllerMode::kCoupled) output = Coupled(i, output, touched);
    // Safe within the loop: a loop edge reads its own node only.
    previous_[i] = output;
    outputs_[static_cast<std::size_t>(joint_of_node_[i])] = output;
  }
  return outputs_;
}

}  // namespace plsc
