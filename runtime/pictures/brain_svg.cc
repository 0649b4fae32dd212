#include "runtime/pictures/brain_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "runtime/compare/brain_difference.h"
#include "runtime/develop/part_names.h"
#include "runtime/pictures/brain_layout.h"
#include "runtime/pictures/svg_panels.h"
#include "runtime/pictures/svg_style.h"
#include "runtime/text/xml.h"

namespace plsc {

namespace {

constexpr int kRadius = 24;        // px, of a node
constexpr int kSquare = 22;        // px, half the side of a module
constexpr int kTextWidth = 190;    // px, right of the joints
constexpr double kThin = 1.2;      // px, an edge of weight 0
constexpr double kThickest = 6.5;  // px, one of weight 1
constexpr std::string_view kPositive = "#0072b2";  // Okabe and Ito's blue
constexpr std::string_view kNegative = "#d55e00";  // and vermillion
// Labels of more edges than this would lie upon each other.
constexpr std::size_t kMostLabels = 24;

constexpr const char* kBrainStyle =
    ".node{stroke-width:2.5} .weight{font-size:12px} .number{font-size:15px} "
    ".part{font-size:13px} .kind{font-size:11px} "
    ".numbers{font-size:12px;text-anchor:start;fill:#222} "
    ".missing{font-size:13px;text-anchor:start;fill:#555}";
constexpr int kLine = 18;  // px, of a line of what is missing
// More are counted.
constexpr std::size_t kMostMissing = 12;

// Solid where the first brain has nothing, dashed where it has other numbers.
std::string MarkStyle(ModuleMark mark, double width) {
  return fmt::format(
      R"(fill="none" stroke="#000" stroke-width="{:.2f}" class="mark"{})",
      width, mark == ModuleMark::kOther ? R"( stroke-dasharray="7 6")" : "");
}

double EdgeWidth(double weight) {
  return kThin + (kThickest - kThin) * std::min(std::abs(weight), 1.0);
}

std::string EdgeStyle(double weight) {
  return fmt::format(R"(fill="none" stroke="{}" stroke-width="{:.2f}"{})",
                     weight < 0 ? kNegative : kPositive, EdgeWidth(weight),
                     weight < 0 ? R"( stroke-dasharray="9 6")" : "");
}

std::string Weight(double weight) {
  return fmt::format("{:+.2f}", weight);
}

// On a white ground, so that the line that it is on does not strike it out.
std::string WeightLabel(double x, double y, double weight) {
  return fmt::format(
      R"(<rect x="{:.1f}" y="{:.1f}" width="38" height="15" fill="#fff" )"
      R"(fill-opacity="0.85"/><text x="{:.1f}" y="{:.1f}" )"
      R"(class="weight">{}</text>)"
      "\n",
      x - 19, y - 7.5, x, y + 4.5, Weight(weight));
}

// Its tip at (x, y), the way it points in unit steps.
std::string ArrowHead(double x, double y, double dx, double dy,
                      std::string_view colour) {
  constexpr double kLength = 13;    // px
  constexpr double kHalfWidth = 6;  // px
  return fmt::format(
      R"(<polygon points="{:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f}" )"
      R"(fill="{}"/>)",
      x, y, x - kLength * dx - kHalfWidth * dy,
      y - kLength * dy + kHalfWidth * dx, x - kLength * dx + kHalfWidth * dy,
      y - kLength * dy - kHalfWidth * dx, colour);
}

class BrainDrawing {
 public:
  BrainDrawing(const Phenotype& robot, const BrainDifference& difference,
               int row_height)
      : robot_(robot),
        difference_(difference),
        layout_(LayOutBrain(robot.brain, row_height)) {}

  std::string Shapes() const {
    std::string svg;
    const auto& edges = robot_.brain.connections;
    const bool has_labels = edges.size() <= kMostLabels;
    for (std::size_t i = 0; i < edges.size(); ++i)
      svg += edges[i].source == edges[i].destination ? LoopShape(i, has_labels)
                                                     : EdgeShape(i, has_labels);
    for (std::size_t i = 0; i < robot_.brain.nodes.size(); ++i)
      svg += NodeShape(static_cast<int>(i));
    if (robot_.brain.nodes.empty())
      svg += R"(<text x="400" y="5" class="number">no sensor, no joint: )"
             "no brain</text>\n";
    return svg;
  }
  int height() const { return layout_.height; }
  /// px, the left end of what is drawn.
  int left() const {
    const bool has_input = std::any_of(
        robot_.brain.nodes.begin(), robot_.brain.nodes.end(),
        [](const Node& node) { return node.type == NodeType::kInput; });
    return has_input ? kSensorColumn - kSquare
                     : kOscillatorColumn - kRadius - 20;
  }

 private:
  const NodePlace& place(int node) const {
    return layout_.places[static_cast<std::size_t>(node)];
  }
  std::string EdgeShape(std::size_t index, bool has_label) const;
  std::string LoopShape(std::size_t index, bool has_label) const;
  std::string CurveShape(std::size_t index, const std::string& path) const;
  std::string NodeShape(int index) const;

  const Phenotype& robot_;
  const BrainDifference& difference_;
  BrainLayout layout_;
};

// With its mark below it, broader, so that both its borders show.
std::string BrainDrawing::CurveShape(std::size_t index,
                                     const std::string& path) const {
  const Connection& edge = robot_.brain.connections[index];
  std::string svg;
  if (difference_.edges[index] != ModuleMark::kShared)
    svg = fmt::format(
        R"(<path d="{}" {}/>)", path,
        MarkStyle(difference_.edges[index], EdgeWidth(edge.weight) + 5));
  return svg + fmt::format(R"(<path d="{}" {}><title>{} {}</title></path>)",
                           path, EdgeStyle(edge.weight), EdgeName(edge),
                           Weight(edge.weight));
}

std::string BrainDrawing::EdgeShape(std::size_t index, bool has_label) const {
  const Connection& edge = robot_.brain.connections[index];
  const NodePlace& from = place(edge.source);
  const NodePlace& to = place(edge.destination);
  const double x0 = from.x + kRadius;
  const double x1 = to.x - kRadius;
  const double bend = (x1 - x0) * 0.45;
  std::string svg = CurveShape(
      index,
      fmt::format("M {:.1f} {} C {:.1f} {} {:.1f} {} {:.1f} {}", x0, from.y,
                  x0 + bend, from.y, x1 - bend - 8, to.y, x1 - 8, to.y));
  svg +=
      ArrowHead(x1, to.y, 1, 0, edge.weight < 0 ? kNegative : kPositive) + '\n';
  if (!has_label) return svg;
  // On the curve; edges of one input part, so by their ends' order further
  // from it.
  const double t = 0.35 + 0.3 * from.share;
  const double u = 1 - t;
  const double x = u * u * u * x0 + 3 * u * u * t * (x0 + bend) +
                   3 * u * t * t * (x1 - bend) + t * t * t * x1;
  const double y =
      (u * u * u + 3 * u * u * t) * from.y + (3 * u * t * t + t * t * t) * to.y;
  return svg + WeightLabel(x, y, edge.weight);
}

std::string BrainDrawing::LoopShape(std::size_t index, bool has_label) const {
  const Connection& edge = robot_.brain.connections[index];
  const NodePlace& at = place(edge.source);
  constexpr double kOut = 26;   // px, to each side
  constexpr double kHigh = 46;  // px, of the curve's control points
  const double top = at.y - kRadius;
  std::string svg = CurveShape(
      index, fmt::format("M {} {:.1f} C {} {:.1f} {} {:.1f} {} {:.1f}",
                         at.x - 10, top + 3, at.x - kOut, top - kHigh,
                         at.x + kOut, top - kHigh, at.x + 12, top - 6));
  svg += ArrowHead(at.x + 9, top + 3, -0.3, 0.95,
                   edge.weight < 0 ? kNegative : kPositive) +
         '\n';
  if (has_label) svg += WeightLabel(at.x + 40, top - 22, edge.weight);
  return svg;
}

std::string BrainDrawing::NodeShape(int index) const {
  const Node& node = robot_.brain.nodes[static_cast<std::size_t>(index)];
  const NodePlace& at = place(index);
  const Module& module =
      robot_.body.modules[static_cast<std::size_t>(node.module)];
  const bool is_input = node.type == NodeType::kInput;
  const std::string_view colour = ModuleColour(module.type);
  const int part_x = is_input ? kSensorColumn : kJointColumn;
  const int from = is_input ? part_x + kSquare : at.x + kRadius;
  const int to = is_input ? at.x - kRadius : part_x - kSquare;
  std::string svg =
      fmt::format(R"(<line x1="{}" y1="{}" x2="{}" y2="{}" stroke="#777" )"
                  R"(stroke-width="2"/>{})"
                  "\n",
                  from, at.y, to - 8, at.y, ArrowHead(to, at.y, 1, 0, "#777"));
  auto out = std::back_inserter(svg);
  fmt::format_to(out,
                 R"(<rect x="{}" y="{}" width="{}" height="{}" fill="{}" )"
                 R"(stroke="#000"/><text x="{}" y="{}" class="part">{}</text>)"
                 R"(<text x="{}" y="{}" class="kind">{}</text>)"
                 "\n",
                 part_x - kSquare, at.y - kSquare, 2 * kSquare, 2 * kSquare,
                 colour, part_x, at.y + 2, ModuleName(module.type), part_x,
                 at.y + 16, ModuleId(robot_.body, node.module));
  fmt::format_to(out,
                 R"(<circle cx="{}" cy="{}" r="{}" fill="#fff" stroke="{}" )"
                 R"(class="node"><title>{}</title></circle>)"
                 R"(<text x="{}" y="{}" class="number">{}</text>)"
                 "\n",
                 at.x, at.y, kRadius, colour, NodeName(index), at.x, at.y + 5,
                 index + 1);
  const ModuleMark mark = difference_.nodes[static_cast<std::size_t>(index)];
  if (mark != ModuleMark::kShared)
    fmt::format_to(out,
                   R"(<circle cx="{}" cy="{}" r="{}" {}/>)"
                   "\n",
                   at.x, at.y, kRadius + 4, MarkStyle(mark, 4));
  if (!is_input)
    fmt::format_to(
        out,
        R"(<text x="{0}" y="{1}" class="numbers">amplitude {3:.2f}, )"
        R"(period {4:.2f} s</text><text x="{0}" y="{2}" )"
        R"(class="numbers">phase offset {5:.2f}, w {6:+.2f}</text>)"
        "\n",
        part_x + kSquare + 8, at.y - 4, at.y + 13, node.amplitude, node.period,
        node.phase_offset, node.weight);
  return svg;
}

std::string PartName(const Phenotype& robot, int node) {
  const int module = robot.brain.nodes[static_cast<std::size_t>(node)].module;
  return fmt::format(
      "{} {}",
      ModuleName(robot.body.modules[static_cast<std::size_t>(module)].type),
      ModuleId(robot.body, module));
}

// What only the first brain has, a line each.
std::vector<std::string> MissingLines(const Phenotype& first,
                                      const BrainDifference& difference) {
  std::vector<std::string> lines;
  for (const int node : difference.missing_nodes)
    lines.push_back(
        fmt::format("node {} of {}", node + 1, PartName(first, node)));
  for (const int index : difference.missing_edges) {
    const Connection& edge =
        first.brain.connections[static_cast<std::size_t>(index)];
    const bool is_loop = edge.source == edge.destination;
    lines.push_back(
        is_loop ? fmt::format("loop of {}, {}", PartName(first, edge.source),
                              Weight(edge.weight))
                : fmt::format(
                      "edge from {} to {}, {}", PartName(first, edge.source),
                      PartName(first, edge.destination), Weight(edge.weight)));
  }
  if (lines.size() <= kMostMissing) return lines;
  const std::size_t rest = lines.size() - kMostMissing;
  lines.resize(kMostMissing);
  lines.push_back(fmt::format("and {} more", rest));
  return lines;
}

std::string MissingText(const std::vector<std::string>& lines,
                        const std::string& first, int left, int top) {
  std::string svg;
  for (std::size_t i = 0; i < lines.size(); ++i)
    svg += fmt::format(R"(<text x="{}" y="{}" class="missing">{}{}</text>)"
                       "\n",
                       left, top + kLine * static_cast<int>(i + 1),
                       i == 0 ? EscapeXml("only in " + first + ": ") : "",
                       lines[i]);
  return svg;
}

std::string CircleIcon(ModuleType type) {
  return fmt::format(
      R"(<circle r="13" fill="#fff" stroke="{}" stroke-width="2.5"/>)",
      ModuleColour(type));
}

std::string LineIcon(double weight) {
  return fmt::format(R"(<line x1="-15" y1="0" x2="15" y2="0" {}/>)",
                     EdgeStyle(weight));
}

std::vector<LegendEntry> LegendOf(const std::vector<DrawnBrain>& brains,
                                  const std::vector<BrainDifference>& marked) {
  bool has_input = false;
  bool has_oscillator = false;
  bool has_edge = false;
  for (const DrawnBrain& drawn : brains) {
    for (const Node& node : drawn.phenotype.brain.nodes)
      (node.type == NodeType::kInput ? has_input : has_oscillator) = true;
    has_edge |= !drawn.phenotype.brain.connections.empty();
  }
  std::vector<LegendEntry> legend;
  if (has_input)
    legend.push_back(
        {CircleIcon(ModuleType::kTouchSensor), "input of a touch sensor"});
  if (has_oscillator)
    legend.push_back({CircleIcon(ModuleType::kVerticalJoint),
                      "oscillator that drives a joint"});
  if (has_edge) {
    legend.push_back({LineIcon(0.6), "positive weight"});
    legend.push_back({LineIcon(-0.6), "negative weight"});
    legend.push_back({"", "(thicker: further from 0)"});
  }
  std::set<ModuleMark> marks;
  for (const BrainDifference& difference : marked) {
    marks.insert(difference.nodes.begin(), difference.nodes.end());
    marks.insert(difference.edges.begin(), difference.edges.end());
  }
  const auto icon = [](ModuleMark mark) {
    return fmt::format(R"(<circle r="12" {}/>)", MarkStyle(mark, 4));
  };
  if (marks.contains(ModuleMark::kNew))
    legend.push_back(
        {icon(ModuleMark::kNew), "not there in " + brains.front().name});
  if (marks.contains(ModuleMark::kOther))
    legend.push_back({icon(ModuleMark::kOther),
                      "other numbers than in " + brains.front().name});
  legend.push_back(
      {"", fmt::format("not drawn: the {} inputs of the core's IMU, which "
                       "have no edges",
                       kImuInputs)});
  return legend;
}

}  // namespace

std::string BrainsSvg(const std::string& title,
                      const std::vector<DrawnBrain>& brains) {
  const bool has_loop =
      std::any_of(brains.begin(), brains.end(), [](const DrawnBrain& drawn) {
        const auto& edges = drawn.phenotype.brain.connections;
        return std::any_of(edges.begin(), edges.end(), [](const auto& edge) {
          return edge.source == edge.destination;
        });
      });
  const int row_height = has_loop ? kLoopRowHeight : kRowHeight;
  std::vector<BrainDifference> differences;
  std::vector<Panel> panels;
  int height = 0;
  for (const DrawnBrain& drawn : brains) {
    const Phenotype& first = brains.front().phenotype;
    differences.push_back(CompareBrains(first, drawn.phenotype));
    const BrainDrawing drawing(drawn.phenotype, differences.back(), row_height);
    const auto missing = MissingLines(first, differences.back());
    const int bottom = drawing.height() - row_height / 2;
    Panel panel;
    panel.title = drawn.name;
    panel.subtitle = drawn.senses;
    panel.left = drawing.left();
    panel.width = kJointColumn + kSquare + kTextWidth - panel.left;
    panel.svg = drawing.Shapes() +
                MissingText(missing, brains.front().name, panel.left, bottom);
    panels.push_back(std::move(panel));
    height = std::max(
        height, drawing.height() + kLine * static_cast<int>(missing.size()));
  }
  for (Panel& panel : panels) {
    // A loop of the first row rises above it.
    panel.top = -row_height / 2 - (has_loop ? 20 : 0);
    panel.height = height + (has_loop ? 20 : 0);
  }
  return PanelsSvg(title, panels, LegendOf(brains, differences), kBrainStyle);
}

}  // namespace plsc
