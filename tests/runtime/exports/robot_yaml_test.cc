#include "runtime/exports/robot_yaml.h"

#include <yaml-cpp/yaml.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "compiler/environment_text.h"
#include "runtime/develop/develop.h"
#include "tests/runtime/develop/compile_text.h"
#include "tests/runtime/develop/reference_cases.h"
#include "tests/runtime/exports/read_robot.h"
#include "tests/sim/authors_bodies.h"

namespace plsc {
namespace {

using test::Json;

/// As the authors' loader tells it from the YAML: the two joints by their
/// accumulated roll.
Json BodyOf(const YAML::Node& module, int roll) {
  Json body;
  const int angle = module["orientation"].as<int>();
  body["id"] = module["id"].as<std::string>();
  body["type"] = module["type"].as<std::string>();
  body["angle"] = angle;
  body["children"] = Json::object();
  for (const auto& child : module["children"])
    body["children"][child.first.as<std::string>()] =
        BodyOf(child.second, roll + angle);
  if (body["type"] == "ActiveHinge")
    body["type"] = (roll + angle) % 180 == 0 ? "A2" : "A1";
  return body;
}

/// The same of a sample: ours are the names of types and slots.
Json BodyOfSample(const Json& module) {
  static const std::map<std::string, std::string> types = {
      {"C", "CoreComponent"}, {"B", "FixedBrick"}, {"T", "TouchSensor"}};
  static const std::map<std::string, std::string> slots = {
      {"back", "0"}, {"front", "1"}, {"right", "2"}, {"left", "3"}};
  Json body;
  const std::string type = module["type"];
  body["id"] = module["id"];
  body["type"] = types.contains(type) ? types.at(type) : type;
  body["angle"] = module["angle"];
  body["children"] = Json::object();
  for (const auto& [slot, child] : module["children"].items())
    body["children"][slots.at(slot)] = BodyOfSample(child);
  return body;
}

/// Of geometry.json, which has slots in the children.
Json BodyOfGeometry(const Json& module, int roll) {
  const int angle = module["angle"];
  Json body{{"id", module["id"]}, {"type", module["type"]}, {"angle", angle}};
  if (body["type"] == "ActiveHinge")
    body["type"] = (roll + angle) % 180 == 0 ? "A2" : "A1";
  body["children"] = Json::object();
  if (module.contains("children"))
    for (const Json& child : module["children"])
      body["children"][std::to_string(child["slot"].get<int>())] =
          BodyOfGeometry(child, roll + angle);
  return body;
}

/// Colours are by type, and tell the joints apart.
void CheckColours(const YAML::Node& module, int roll) {
  const int accumulated = roll + module["orientation"].as<int>();
  const std::string type = module["type"].as<std::string>();
  std::vector<double> rgb;
  for (const char* colour : {"red", "green", "blue"})
    rgb.push_back(module["params"][colour].as<double>());
  const std::map<std::string, std::vector<double>> colours = {
      {"CoreComponent", {1, 1, 0}},
      {"FixedBrick", {0, 0, 1}},
      {"TouchSensor", {0.7, 0.7, 0.7}}};
  if (colours.contains(type))
    CHECK(rgb == colours.at(type));
  else
    CHECK(rgb == (accumulated % 180 == 0 ? std::vector<double>{1, 0.08, 0.58}
                                         : std::vector<double>{0.7, 0, 0}));
  for (const auto& child : module["children"])
    CheckColours(child.second, accumulated);
}

void CheckNeurons(const YAML::Node& brain, const Json& expected) {
  std::size_t oscillators = 0;
  CHECK(brain["neurons"].size() == expected["nodes"].size() + 6);
  for (const Json& node : expected["nodes"]) {
    const std::string id = node["id"];
    const YAML::Node neuron = brain["neurons"][id];
    REQUIRE(neuron);
    const bool is_input = node["type"] == "Input";
    CHECK(neuron["id"].as<std::string>() == id);
    CHECK(neuron["type"].as<std::string>() == node["type"]);
    CHECK(neuron["layer"].as<std::string>() == (is_input ? "input" : "output"));
    CHECK(neuron["part_id"].as<std::string>() == node["part"]);
    if (is_input) continue;
    ++oscillators;
    for (const char* key : {"amplitude", "period", "phase_offset"})
      CHECK(brain["params"][id][key].as<double>() == node[key]);
  }
  CHECK(brain["params"].size() == oscillators);
  for (int i = 1; i <= 6; ++i) {
    const YAML::Node imu = brain["neurons"]["node-core" + std::to_string(i)];
    REQUIRE(imu);
    CHECK(imu["layer"].as<std::string>() == "input");
    CHECK(imu["part_id"].as<std::string>() == "1");
  }
}

void CheckConnections(const YAML::Node& brain, const Json& expected) {
  // The key is not there when there are none.
  CHECK(brain["connections"].IsDefined() != expected["connections"].empty());
  std::size_t i = 0;
  for (const Json& edge : expected["connections"]) {
    const YAML::Node read = brain["connections"][i++];
    CHECK(read["src"].as<std::string>() == edge["src"]);
    CHECK(read["dst"].as<std::string>() == edge["dst"]);
    CHECK(read["weight"].as<double>() == edge["weight"]);
  }
}

TEST_CASE("The YAML is the authors' robot, for each of the samples",
          "[robot_yaml][slow]") {
  int compared = 0;
  for (const std::string& set : test::ReferenceSets())
    for (const Json& one : test::ReadReferenceCases(set)) {
      INFO(one["id"]);
      const Genotype genotype =
          test::CompileText(test::GenotypeText(one)).genotype;
      const Source senses("--env", test::EnvironmentText(one));
      const auto environment = ParseEnvironment(senses, genotype.states);
      const auto phenotype = Develop(genotype, *environment);
      REQUIRE(phenotype);
      const YAML::Node yaml = YAML::Load(
          RobotYaml(ModelOf({"robot_9", set}, *phenotype, ExportedOptions())));
      CHECK(yaml["id"].as<std::string>() == "robot_9");
      CHECK(BodyOf(yaml["body"], 0) == BodyOfSample(one["expected"]["body"]));
      CheckColours(yaml["body"], 0);
      CHECK(yaml["brain"]["type"].as<std::string>() == "neural-network");
      CheckNeurons(yaml["brain"], one["expected"]["brain"]);
      CheckConnections(yaml["brain"], one["expected"]["brain"]);
      ++compared;
    }
  CHECK(compared == 549);
}

TEST_CASE("The YAML is the authors' body, for each of geometry.json",
          "[robot_yaml]") {
  std::size_t compared = 0;
  const Json bodies = LoadAuthorsBodies();
  for (const test::AuthorsRobot& robot : test::AuthorsRobots()) {
    INFO(robot.name);
    const YAML::Node yaml = YAML::Load(RobotYaml(robot.model));
    CHECK(BodyOf(yaml["body"], 0) ==
          BodyOfGeometry(bodies.at(compared++).at("body"), 0));
  }
  CHECK(compared == 100);
}

TEST_CASE("A robot without brain has what the loader asks for",
          "[robot_yaml]") {
  const std::string yaml =
      RobotYaml(ModelOf({"it's", "any"}, {LoneCore(), {}}, ExportedOptions()));
  CHECK(yaml.find("id: 'it''s'\nbody:\n  id: '1'\n  type: CoreComponent\n") ==
        0);
  CHECK(yaml.find("children") == std::string::npos);
  CHECK(yaml.find("connections") == std::string::npos);
  CHECK(yaml.find("  params: {}\n") != std::string::npos);
  CHECK(YAML::Load(yaml)["brain"]["neurons"].size() == 6);
}

TEST_CASE("Python reads every number as one", "[robot_yaml]") {
  struct Row {
    const char* why;
    double number;
    const char* text;
  };
  const Row rows[] = {
      {"no integer", 2, "2.0"},
      {"as it is", 0.25, "0.25"},
      {"all digits", 0.1 + 0.2, "0.30000000000000004"},
      {"1e-05 is a text in YAML 1.1", 1e-05, "1.0e-05"},
      {"with a point already", 1.5e-07, "1.5e-07"},
      {"large", 1e22, "1.0e+22"},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    CHECK(YamlFloat(row.number) == row.text);
  }
}

}  // namespace
}  // namespace plsc
