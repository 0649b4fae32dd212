// The reading half of golden_json.h.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "runtime/compare/golden_json.h"
#include "runtime/develop/descriptors.h"
#include "runtime/text/json_reader.h"
#include "runtime/text/json_text.h"

namespace plsc {

namespace {

constexpr std::int64_t kMaxInt = std::numeric_limits<int>::max();

template <std::size_t N>
bool IsObject(JsonReader& reader, const JsonValue& value,
              const std::array<std::string_view, N>& known) {
  return reader.IsObject(value, known);
}

int ReadInt(JsonReader& reader, const JsonValue& object, std::string_view key) {
  return static_cast<int>(reader.Integer(object, key, -kMaxInt, kMaxInt));
}

GoldenModule ReadModule(JsonReader& reader, const JsonValue& value) {
  static constexpr std::array<std::string_view, 8> kKnown{
      "id", "type", "parent", "slot", "x", "y", "facing", "angle"};
  GoldenModule module;
  if (!IsObject(reader, value, kKnown)) return module;
  module.id = reader.Text(value, "id");
  module.type = reader.Text(value, "type");
  if (reader.Has(value, "parent") || reader.Has(value, "slot")) {
    module.parent = reader.Text(value, "parent");
    module.slot = reader.Text(value, "slot");
    // Empty ones mean the core, which has neither key.
    if (module.parent.empty() || module.slot.empty())
      reader.Error(value, Code::kMisfit,
                   "expected the id of a module and its slot",
                   "the core has neither 'parent' nor 'slot'");
  }
  if (reader.Has(value, "x") || reader.Has(value, "y") ||
      reader.Has(value, "facing")) {
    module.cell =
        GoldenCell{ReadInt(reader, value, "x"), ReadInt(reader, value, "y")};
    module.facing = reader.Text(value, "facing");
  }
  module.angle_deg = ReadInt(reader, value, "angle");
  return module;
}

GoldenNode ReadNode(JsonReader& reader, const JsonValue& value) {
  static constexpr std::array<std::string_view, 7> kKnown{
      "id", "type", "module", "weight", "amplitude", "period", "phase_offset"};
  GoldenNode node;
  if (!IsObject(reader, value, kKnown)) return node;
  node.id = reader.Text(value, "id");
  const std::string type = reader.Text(value, "type");
  if (type != "Input" && type != "Oscillator")
    reader.Error(value, Code::kUnknownWord,
                 fmt::format("expected Input or Oscillator for 'type', found "
                             "'{}'",
                             type));
  node.module = reader.Text(value, "module");
  node.weight = reader.Number(value, "weight");
  node.is_oscillator = type == "Oscillator";
  if (!node.is_oscillator) return node;
  node.amplitude = reader.Number(value, "amplitude");
  node.period = reader.Number(value, "period");
  node.phase_offset = reader.Number(value, "phase_offset");
  return node;
}

GoldenEdge ReadEdge(JsonReader& reader, const JsonValue& value) {
  static constexpr std::array<std::string_view, 3> kKnown{"from", "to",
                                                          "weight"};
  if (!IsObject(reader, value, kKnown)) return {};
  return {reader.Text(value, "from"), reader.Text(value, "to"),
          reader.Number(value, "weight")};
}

// In the order of `names`, others behind: nlohmann-json sorts keys.
GoldenValues ReadValues(JsonReader& reader, const JsonValue& object,
                        std::string_view key,
                        const std::vector<NamedValue>& names) {
  GoldenValues values;
  const nlohmann::json* member = reader.Member(object, key);
  if (member == nullptr) return values;
  const JsonValue value{*member, &object, std::string(key)};
  if (!member->is_object()) {
    reader.Wrong(value, "an object");
    return values;
  }
  for (const auto& [name, number] : member->items())
    values.emplace_back(name, reader.Number(JsonValue{number, &value, name}));
  const auto rank = [&](const auto& entry) {
    return std::find_if(names.begin(), names.end(), [&](const NamedValue& n) {
      return n.name == entry.first;
    });
  };
  std::stable_sort(
      values.begin(), values.end(),
      [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return values;
}

GoldenString ReadString(JsonReader& reader, const JsonValue& value) {
  GoldenString string;
  reader.List(value, "string", [&](const JsonValue& symbol) {
    string.symbols.push_back(reader.Text(symbol));
  });
  string.length = string.symbols.size();
  if (reader.Has(value, "string_length") || reader.Has(value, "string_hash")) {
    string.length = static_cast<std::size_t>(
        reader.Integer(value, "string_length", 0, kMaxInt));
    string.hash = reader.Text(value, "string_hash");
    if (string.hash.empty())
      reader.Error(value, Code::kMisfit, "expected the hash of a long string",
                   "shorter strings have neither hash nor length");
  }
  return string;
}

GoldenRobot ReadRobot(JsonReader& reader, const JsonValue& value) {
  GoldenRobot robot;
  reader.List(value, "body", [&](const JsonValue& module) {
    robot.modules.push_back(ReadModule(reader, module));
  });
  reader.List(value, "nodes", [&](const JsonValue& node) {
    robot.nodes.push_back(ReadNode(reader, node));
  });
  reader.List(value, "edges", [&](const JsonValue& edge) {
    robot.edges.push_back(ReadEdge(reader, edge));
  });
  robot.body_descriptors =
      ReadValues(reader, value, "body_descriptors", List(BodyDescriptors{}));
  robot.brain_descriptors =
      ReadValues(reader, value, "brain_descriptors", List(BrainDescriptors{}));
  return robot;
}

Observation ReadExpected(JsonReader& reader, const JsonValue& value) {
  Observation expected;
  if (reader.Has(value, "senses"))
    expected.senses = reader.Text(value, "senses");
  reader.List(value, "active_rules", [&](const JsonValue& rule) {
    expected.active_rules.push_back(
        static_cast<int>(reader.Integer(rule, 1, kMaxInt)));
  });
  expected.string = ReadString(reader, value);
  for (const char* key :
       {"body", "nodes", "edges", "body_descriptors", "brain_descriptors"})
    if (reader.Has(value, key)) {
      expected.robot = ReadRobot(reader, value);
      break;
    }
  return expected;
}

GoldenCase ReadCase(JsonReader& reader, const JsonValue& value) {
  static constexpr std::array<std::string_view, 12> kKnown{
      "genotype", "environment",   "senses",           "active_rules",
      "string",   "string_length", "string_hash",      "body",
      "nodes",    "edges",         "body_descriptors", "brain_descriptors"};
  GoldenCase golden;
  if (!IsObject(reader, value, kKnown)) return golden;
  const bool has_genotype = reader.Has(value, "genotype");
  if (has_genotype) golden.genotype = reader.Text(value, "genotype");
  golden.environment = reader.Text(value, "environment");
  if (value.json.size() > (has_genotype ? 2 : 1))
    golden.expected = ReadExpected(reader, value);
  return golden;
}

void ReadCases(JsonReader& reader, const JsonValue& root, Golden& golden) {
  std::set<std::pair<std::string, std::string>> names;
  reader.List(root, "environments", [&](const JsonValue& value) {
    golden.cases.push_back(ReadCase(reader, value));
    const GoldenCase& last = golden.cases.back();
    const std::string& name = last.environment;
    if (!names.emplace(last.genotype, name).second)
      reader.Error(value, Code::kMisfit,
                   fmt::format("environment '{}' stands twice", name),
                   "every environment has one expectation");
  });
}

Golden ReadGolden(JsonReader& reader, const JsonValue& root) {
  static constexpr std::array<std::string_view, 3> kKnown{
      "plsc_golden", "descriptor_tolerance", "environments"};
  Golden golden;
  if (!root.json.is_object()) {
    reader.Wrong(root, "an object");
    return golden;
  }
  if (!reader.IsReadable(root, "plsc_golden", kGoldenVersion, "golden file"))
    return golden;
  IsObject(reader, root, kKnown);
  if (reader.Has(root, "descriptor_tolerance"))
    golden.descriptor_tolerance = reader.Number(root, "descriptor_tolerance");
  if (golden.descriptor_tolerance < 0)
    reader.Error(JsonValue{root.json["descriptor_tolerance"], &root,
                           "descriptor_tolerance"},
                 Code::kOutOfRange, "a tolerance is 0 or more");
  ReadCases(reader, root, golden);
  if (golden.cases.empty() && reader.errors().empty())
    reader.Error(root, Code::kMisfit, "no environment to test in",
                 "name at least one in 'environments'");
  return golden;
}

}  // namespace

Result<Golden> ParseGolden(const Source& source) {
  const Result<nlohmann::json> json = ReadJson(source);
  if (!json) {
    std::vector<Diagnostic> problems = json.diagnostics();
    if (problems.front().code == Code::kEmptyFile)
      problems.front().help = "remove it and run plsc test --update";
    return problems;
  }
  JsonReader reader(source);
  Golden golden = ReadGolden(reader, JsonValue{*json, nullptr, ""});
  if (!reader.errors().empty()) return reader.errors();
  return golden;
}

}  // namespace plsc
