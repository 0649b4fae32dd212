#include "runtime/compare/golden_json.h"

#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "grammar/number.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

// An object on one line.
std::string Line(
    const std::vector<std::pair<std::string_view, Json>>& members) {
  std::string text;
  for (const auto& [key, value] : members) {
    if (!text.empty()) text += ", ";
    text += Json(key).dump() + ": " + value.dump();
  }
  return "{" + text + "}";
}

Json Text(const std::string& text) {
  return text;
}

std::string ModuleLine(const GoldenModule& module) {
  std::vector<std::pair<std::string_view, Json>> members{
      {"id", Text(module.id)}, {"type", Text(module.type)}};
  if (!module.parent.empty()) {
    members.emplace_back("parent", Text(module.parent));
    members.emplace_back("slot", Text(module.slot));
  }
  if (module.cell) {
    members.emplace_back("x", module.cell->x);
    members.emplace_back("y", module.cell->y);
    members.emplace_back("facing", Text(module.facing));
  }
  members.emplace_back("angle", module.angle_deg);
  return Line(members);
}

std::string NodeLine(const GoldenNode& node) {
  if (!node.is_oscillator)
    return Line({{"id", Text(node.id)},
                 {"type", Text("Input")},
                 {"module", Text(node.module)},
                 {"weight", node.weight}});
  return Line({{"id", Text(node.id)},
               {"type", Text("Oscillator")},
               {"module", Text(node.module)},
               {"weight", node.weight},
               {"amplitude", node.amplitude},
               {"period", node.period},
               {"phase_offset", node.phase_offset}});
}

std::string EdgeLine(const GoldenEdge& edge) {
  return Line({{"from", Text(edge.source)},
               {"to", Text(edge.destination)},
               {"weight", edge.weight}});
}

// The members of one object, each on its own lines.
class Block {
 public:
  explicit Block(int indent) : indent_(static_cast<std::size_t>(indent), ' ') {}

  void Add(std::string_view key, const std::string& value) {
    text_ += text_.empty() ? "\n" : ",\n";
    text_ += indent_ + Json(key).dump() + ": " + value;
  }
  // `lines` between brackets, an element a line.
  void AddLines(std::string_view key, const std::vector<std::string>& lines,
                char open, char close) {
    std::string value(1, open);
    for (std::size_t i = 0; i < lines.size(); ++i)
      value += (i == 0 ? "\n  " : ",\n  ") + indent_ + lines[i];
    if (!lines.empty()) value += "\n" + indent_;
    Add(key, value + close);
  }
  template <typename Part, typename Writer>
  void AddList(std::string_view key, const std::vector<Part>& parts,
               Writer line) {
    std::vector<std::string> lines;
    lines.reserve(parts.size());
    for (const Part& part : parts) lines.push_back(line(part));
    AddLines(key, lines, '[', ']');
  }
  void AddValues(std::string_view key, const GoldenValues& values) {
    std::vector<std::string> lines;
    for (const auto& [name, value] : values)
      lines.push_back(Json(name).dump() + ": " + PrintNumber(value));
    AddLines(key, lines, '{', '}');
  }
  const std::string& text() const { return text_; }

 private:
  std::string indent_;
  std::string text_;
};

void AddRobot(const GoldenRobot& robot, Block& block) {
  block.AddList("body", robot.modules, ModuleLine);
  block.AddList("nodes", robot.nodes, NodeLine);
  block.AddList("edges", robot.edges, EdgeLine);
  block.AddValues("body_descriptors", robot.body_descriptors);
  block.AddValues("brain_descriptors", robot.brain_descriptors);
}

std::string CaseText(const GoldenCase& golden) {
  Block block(6);
  if (!golden.genotype.empty())
    block.Add("genotype", Json(golden.genotype).dump());
  block.Add("environment", Json(golden.environment).dump());
  if (golden.expected) {
    const Observation& expected = *golden.expected;
    if (!expected.senses.empty())
      block.Add("senses", Json(expected.senses).dump());
    block.Add("active_rules", Json(expected.active_rules).dump());
    if (!expected.string.hash.empty()) {
      block.Add("string_length", Json(expected.string.length).dump());
      block.Add("string_hash", Json(expected.string.hash).dump());
    }
    block.AddList("string", expected.string.symbols,
                  [](const std::string& s) { return Json(s).dump(); });
    if (expected.robot) AddRobot(*expected.robot, block);
  }
  return "{" + block.text() + "\n    }";
}

}  // namespace

std::string PrintGolden(const Golden& golden) {
  Block block(2);
  block.Add("plsc_golden", Json(kGoldenVersion).dump());
  block.Add("descriptor_tolerance", Json(golden.descriptor_tolerance).dump());
  block.AddList("environments", golden.cases, CaseText);
  return "{" + block.text() + "\n}\n";
}

}  // namespace plsc
