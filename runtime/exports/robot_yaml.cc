#include "runtime/exports/robot_yaml.h"

#include <fmt/format.h>

#include <cassert>
#include <cstddef>

#include "grammar/number.h"
#include "runtime/exports/robot_model.h"

namespace plsc {

namespace {

std::string_view AuthorsType(ModuleType type) {
  switch (type) {
    case ModuleType::kCore:
      return "CoreComponent";
    case ModuleType::kBrick:
      return "FixedBrick";
    case ModuleType::kVerticalJoint:
    case ModuleType::kHorizontalJoint:
      return "ActiveHinge";
    case ModuleType::kTouchSensor:
      return "TouchSensor";
  }
  assert(false);
  return "";
}

// Quoted, as "1" and "true" would be no texts else.
std::string Quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
  return quoted + "'";
}

// "node1"; those of the IMU are "node-core1".
std::string NodeId(int index) {
  return fmt::format("node{}", index + 1);
}

// Recursion is as deep as the body.
void AddModule(const Body& body, int index, std::size_t level,
               std::string& text) {
  const std::string indent(2 * level, ' ');
  const Module& module = body.modules[static_cast<std::size_t>(index)];
  const auto colour = AuthorsColour(module.type);
  text += fmt::format(
      "{0}id: {1}\n{0}type: {2}\n{0}orientation: {3}\n{0}params:\n"
      "{0}  blue: {4}\n{0}  green: {5}\n{0}  red: {6}\n",
      indent, Quoted(ModuleId(body, index)), AuthorsType(module.type),
      module.angle_deg, colour[2], colour[1], colour[0]);
  bool has_children = false;
  for (int slot = 0; slot < kSlots; ++slot) {
    const int child = module.child(static_cast<Slot>(slot));
    if (child == kNoModule) continue;
    if (!has_children) text += indent + "children:\n";
    has_children = true;
    text += fmt::format("{}  {}:\n", indent, slot);
    AddModule(body, child, level + 2, text);
  }
}

std::string NeuronText(const std::string& id, bool is_input,
                       const std::string& part) {
  return fmt::format(
      "    {0}:\n      id: {0}\n      layer: {1}\n      part_id: {2}\n"
      "      type: {3}\n",
      id, is_input ? "input" : "output", Quoted(part),
      is_input ? "Input" : "Oscillator");
}

std::string Neurons(const Phenotype& phenotype) {
  std::string text = "  neurons:\n";
  const auto& nodes = phenotype.brain.nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    text += NeuronText(NodeId(static_cast<int>(i)),
                       nodes[i].type == NodeType::kInput,
                       ModuleId(phenotype.body, nodes[i].module));
  for (int i = 1; i <= kImuInputs; ++i)
    text += NeuronText(fmt::format("node-core{}", i), true,
                       ModuleId(phenotype.body, 0));
  return text;
}

/// Without the key where there are none, as the authors' program has it.
std::string Connections(const Brain& brain) {
  if (brain.connections.empty()) return "";
  std::string text = "  connections:\n";
  for (const Connection& one : brain.connections)
    text += fmt::format("  - dst: {}\n    src: {}\n    weight: {}\n",
                        NodeId(one.destination), NodeId(one.source),
                        YamlFloat(one.weight));
  return text;
}

std::string Oscillators(const Brain& brain) {
  std::string text;
  for (std::size_t i = 0; i < brain.nodes.size(); ++i) {
    const Node& node = brain.nodes[i];
    if (node.type != NodeType::kOscillator) continue;
    text += fmt::format(
        "    {}:\n      amplitude: {}\n      period: {}\n"
        "      phase_offset: {}\n",
        NodeId(static_cast<int>(i)), YamlFloat(node.amplitude),
        YamlFloat(node.period), YamlFloat(node.phase_offset));
  }
  return text.empty() ? "  params: {}\n" : "  params:\n" + text;
}

}  // namespace

std::string YamlFloat(double number) {
  std::string text = PrintPlainNumber(number);
  const std::size_t exponent = text.find('e');
  if (text.find('.') == std::string::npos)
    text.insert(exponent == std::string::npos ? text.size() : exponent, ".0");
  return text;
}

std::string RobotYaml(const RobotModel& model) {
  const Phenotype& phenotype = model.phenotype;
  std::string text = "id: " + Quoted(model.name) + "\nbody:\n";
  AddModule(phenotype.body, 0, 1, text);
  text += "brain:\n  type: neural-network\n";
  text += Neurons(phenotype);
  text += Connections(phenotype.brain);
  text += Oscillators(phenotype.brain);
  return text;
}

}  // namespace plsc
