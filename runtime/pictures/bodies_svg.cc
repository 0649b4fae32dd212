#include "runtime/pictures/bodies_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <utility>

#include "grammar/enum_names.h"
#include "runtime/pictures/body_shapes.h"
#include "runtime/pictures/svg_panels.h"
#include "runtime/pictures/svg_style.h"
#include "runtime/text/xml.h"

namespace plsc {

namespace {

constexpr const char* kBodiesStyle =
    ".name{font-size:28px} .id{font-size:16px} .note{font-size:15px}";
constexpr int kIcon = kLegendIcon / 2;  // px, half the side

using Painter = std::function<std::vector<ModulePaint>(const DrawnBody&)>;

// The rows of cells are the same in all panels, so that cores lie on a line.
std::vector<Panel> PanelsOf(const std::vector<DrawnBody>& bodies,
                            const Painter& paint) {
  CellExtent all;
  for (const DrawnBody& drawn : bodies) all.Include(drawn.body);
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const DrawnBody& drawn = bodies[i];
    const Body& reference = bodies.front().body;
    CellExtent extent;
    extent.Include(drawn.body);
    if (i > 0) extent.Include(reference);  // dotted where it has no module
    Panel panel;
    panel.title = drawn.name;
    panel.subtitle = drawn.senses;
    panel.svg = BodyShapes(
        drawn.body, paint(drawn),
        i == 0 ? std::string()
               : DifferenceShapes(reference, drawn.body,
                                  CompareBodies(reference, drawn.body)));
    panel.left = extent.left * kCellSide - kCellSide / 2;
    panel.top = -all.front * kCellSide - kCellSide / 2;
    panel.width = extent.columns() * kCellSide;
    panel.height = all.rows() * kCellSide;
    panels.push_back(std::move(panel));
  }
  return panels;
}

std::string SquareIcon(std::string_view fill, std::string_view ink,
                       const std::string& text) {
  return fmt::format(
      R"(<rect x="{0}" y="{0}" width="{1}" height="{1}" fill="{2}" )"
      R"(stroke="#000"/><text y="5" font-size="14" fill="{3}">{4}</text>)",
      -kIcon + 1, 2 * kIcon - 2, fill, ink, EscapeXml(text));
}

std::string BarIcon() {
  return fmt::format(R"(<rect x="-10" y="-4" width="20" height="8" fill="{}" )"
                     R"(stroke="#000"/>)",
                     ModuleColour(ModuleType::kTouchSensor));
}

std::string_view LongName(ModuleType type) {
  constexpr EnumNames<ModuleType, 5> kNames{
      {{ModuleType::kCore, "core"},
       {ModuleType::kBrick, "brick"},
       {ModuleType::kVerticalJoint, "vertical joint"},
       {ModuleType::kHorizontalJoint, "horizontal joint"},
       {ModuleType::kTouchSensor, "touch sensor"}}};
  return NameIn(kNames, type);
}

bool Has(const std::vector<DrawnBody>& bodies, ModuleType type) {
  return std::any_of(
      bodies.begin(), bodies.end(), [type](const DrawnBody& drawn) {
        return std::any_of(
            drawn.body.modules.begin(), drawn.body.modules.end(),
            [type](const Module& module) { return module.type == type; });
      });
}

std::vector<LegendEntry> TypeLegend(const std::vector<DrawnBody>& bodies) {
  std::vector<LegendEntry> legend;
  for (const ModuleType type :
       {ModuleType::kCore, ModuleType::kBrick, ModuleType::kVerticalJoint,
        ModuleType::kHorizontalJoint, ModuleType::kTouchSensor}) {
    if (!Has(bodies, type)) continue;
    const bool is_bar = type == ModuleType::kTouchSensor;
    legend.push_back({is_bar ? BarIcon()
                             : SquareIcon(ModuleColour(type), "#000",
                                          std::string(ModuleName(type))),
                      std::string(LongName(type))});
  }
  return legend;
}

std::vector<LegendEntry> DifferenceLegend(
    const std::vector<DrawnBody>& bodies) {
  std::set<ModuleMark> marks;
  bool has_missing = false;
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const BodyDifference difference =
        CompareBodies(bodies.front().body, bodies[i].body);
    marks.insert(difference.marks.begin(), difference.marks.end());
    has_missing |= !difference.missing.empty();
  }
  const std::string& first =
      bodies.empty() ? std::string() : bodies.front().name;
  std::vector<LegendEntry> legend;
  if (marks.contains(ModuleMark::kNew))
    legend.push_back({MarkShape(0, 0, kIcon - 4, ModuleMark::kNew),
                      "not there in " + first});
  if (marks.contains(ModuleMark::kOther))
    legend.push_back({MarkShape(0, 0, kIcon - 4, ModuleMark::kOther),
                      "another module than in " + first});
  if (has_missing)
    legend.push_back(
        {MissingShape(0, 0, kIcon - 4), "there in " + first + " only"});
  return legend;
}

std::string NoteOf(RuleIndex rule) {
  return rule == kNoRule ? "axiom" : fmt::format("rule {}", rule + 1);
}

InkOn ColourOf(const std::vector<RuleIndex>& rules, RuleIndex rule) {
  if (rule == kNoRule) return {"#fff", "#000"};
  const auto place = std::find(rules.begin(), rules.end(), rule);
  return NumberColour(static_cast<std::size_t>(place - rules.begin()));
}

std::vector<LegendEntry> Joined(std::vector<LegendEntry> one,
                                std::vector<LegendEntry> other) {
  std::move(other.begin(), other.end(), std::back_inserter(one));
  return one;
}

}  // namespace

std::vector<RuleIndex> RulesOf(const std::vector<DrawnBody>& bodies) {
  std::set<RuleIndex> rules;
  for (const DrawnBody& drawn : bodies)
    rules.insert(drawn.rules.begin(), drawn.rules.end());
  return {rules.begin(), rules.end()};  // kNoRule is the greatest number
}

std::string BodiesSvg(const std::string& title,
                      const std::vector<DrawnBody>& bodies) {
  const auto paint = [](const DrawnBody& drawn) {
    return PaintByType(drawn.body);
  };
  return PanelsSvg(title, PanelsOf(bodies, paint),
                   Joined(TypeLegend(bodies), DifferenceLegend(bodies)),
                   kBodiesStyle);
}

std::string BodiesByRuleSvg(const std::string& title,
                            const std::vector<DrawnBody>& bodies,
                            const std::vector<std::string>& rule_texts) {
  const std::vector<RuleIndex> rules = RulesOf(bodies);
  const auto paint = [&](const DrawnBody& drawn) {
    std::vector<ModulePaint> paints;
    for (const RuleIndex rule : drawn.rules) {
      const InkOn colour = ColourOf(rules, rule);
      paints.push_back(
          {std::string(colour.fill), std::string(colour.ink), NoteOf(rule)});
    }
    return paints;
  };
  std::vector<LegendEntry> legend;
  for (const RuleIndex rule : rules) {
    const InkOn colour = ColourOf(rules, rule);
    const bool is_axiom = rule == kNoRule;
    legend.push_back({SquareIcon(colour.fill, colour.ink,
                                 is_axiom ? "" : std::to_string(rule + 1)),
                      is_axiom ? "the axiom" : rule_texts[rule]});
  }
  return PanelsSvg(title, PanelsOf(bodies, paint),
                   Joined(std::move(legend), DifferenceLegend(bodies)),
                   kBodiesStyle);
}

}  // namespace plsc
