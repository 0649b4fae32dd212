#include "runtime/pictures/brain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/compare/brain_difference.h"
#include "runtime/develop/part_names.h"

namespace plsc {

namespace {

constexpr int kBarLength = 10;  // characters of a weight of 1

std::string PartOf(const Body& body, const Node& node) {
  const auto type = body.modules[static_cast<std::size_t>(node.module)].type;
  return fmt::format("{} {}", ModuleName(type), ModuleId(body, node.module));
}

/// Inputs first, then oscillators, each in the order of their modules.
std::vector<int> OrderOf(const Brain& brain) {
  std::vector<int> order(brain.nodes.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int index) {
    const Node& node = brain.nodes[static_cast<std::size_t>(index)];
    return std::pair(node.type != NodeType::kInput, node.module);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](int one, int other) { return key(one) < key(other); });
  return order;
}

std::string NodeLine(const Phenotype& robot, int index) {
  const Node& node = robot.brain.nodes[static_cast<std::size_t>(index)];
  const std::string name = NodeName(index);
  const std::string part = PartOf(robot.body, node);
  if (node.type == NodeType::kInput)
    return fmt::format("{:<8} → ( {} )\n", part, name);
  return fmt::format("( {} ) → {:<6} a {:.2f}, p {:.2f} s, o {:.2f}\n", name,
                     part, node.amplitude, node.period, node.phase_offset);
}

std::string BarText(double weight) {
  const int length = static_cast<int>(
      std::lround(std::min(std::abs(weight), 1.0) * kBarLength));
  std::string bar;
  for (int i = 0; i < std::max(length, 1); ++i) bar += weight < 0 ? "╌" : "━";
  return bar;
}

std::string EdgeLine(const Connection& edge) {
  const bool is_loop = edge.source == edge.destination;
  return fmt::format("{:>7} {} {:<7} {:+.2f} {}\n", NodeName(edge.source),
                     is_loop ? "↺" : "→",
                     is_loop ? std::string() : NodeName(edge.destination),
                     edge.weight, BarText(edge.weight));
}

std::string_view SignOf(ModuleMark mark) {
  return mark == ModuleMark::kNew     ? "━ "
         : mark == ModuleMark::kOther ? "═ "
                                      : "  ";
}

constexpr const char* kNoBrain = "no sensor, no joint: no brain\n";

}  // namespace

std::string BrainText(const Phenotype& robot) {
  if (robot.brain.nodes.empty()) return kNoBrain;
  std::string text;
  for (const int node : OrderOf(robot.brain)) text += NodeLine(robot, node);
  for (const Connection& edge : robot.brain.connections) text += EdgeLine(edge);
  return text;
}

std::string BrainText(const Phenotype& robot, const Phenotype& reference) {
  const BrainDifference difference = CompareBrains(reference, robot);
  std::string text = robot.brain.nodes.empty() ? kNoBrain : "";
  for (const int node : OrderOf(robot.brain)) {
    text += SignOf(difference.nodes[static_cast<std::size_t>(node)]);
    text += NodeLine(robot, node);
  }
  for (std::size_t i = 0; i < difference.edges.size(); ++i) {
    text += SignOf(difference.edges[i]);
    text += EdgeLine(robot.brain.connections[i]);
  }
  for (const int node : difference.missing_nodes)
    text += "╌ " + NodeLine(reference, node);
  for (const int edge : difference.missing_edges)
    text +=
        "╌ " +
        EdgeLine(reference.brain.connections[static_cast<std::size_t>(edge)]);
  return text;
}

}  // namespace plsc
