#include "runtime/formats/brain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "runtime/formats/history_view.h"

namespace plsc {

namespace {

constexpr int kBar = 10;  // characters of a weight of 1

std::string PartOf(const Body& body, const Node& node) {
  const auto type = body.modules[static_cast<std::size_t>(node.module)].type;
  return fmt::format("{} {}", ModuleName(type), ModuleId(body, node.module));
}

void AddNodes(const Phenotype& robot, NodeType type, std::string& text) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < robot.brain.nodes.size(); ++i)
    if (robot.brain.nodes[i].type == type) order.push_back(i);
  std::stable_sort(
      order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return robot.brain.nodes[a].module < robot.brain.nodes[b].module;
      });
  for (const std::size_t i : order) {
    const Node& node = robot.brain.nodes[i];
    const std::string name = NodeName(static_cast<int>(i));
    const std::string part = PartOf(robot.body, node);
    if (type == NodeType::kInput)
      text += fmt::format("{:<8} → ( {} )\n", part, name);
    else
      text +=
          fmt::format("( {} ) → {:<6} a {:.2f}, p {:.2f} s, o {:.2f}\n", name,
                      part, node.amplitude, node.period, node.phase_offset);
  }
}

std::string Bar(double weight) {
  const int length =
      static_cast<int>(std::lround(std::min(std::abs(weight), 1.0) * kBar));
  std::string bar;
  for (int i = 0; i < std::max(length, 1); ++i) bar += weight < 0 ? "╌" : "━";
  return bar;
}

}  // namespace

std::string BrainText(const Phenotype& robot) {
  if (robot.brain.nodes.empty()) return "no sensor, no joint: no brain\n";
  std::string text;
  AddNodes(robot, NodeType::kInput, text);
  AddNodes(robot, NodeType::kOscillator, text);
  for (const Connection& edge : robot.brain.connections) {
    const bool is_loop = edge.source == edge.destination;
    text += fmt::format("{:>7} {} {:<7} {:+.2f} {}\n", NodeName(edge.source),
                        is_loop ? "↺" : "→",
                        is_loop ? std::string() : NodeName(edge.destination),
                        edge.weight, Bar(edge.weight));
  }
  return text;
}

}  // namespace plsc
