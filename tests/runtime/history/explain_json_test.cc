#include "runtime/history/explain_json.h"

#include <nlohmann/json.hpp>

#include "tests/runtime/develop/grown.h"

namespace plsc {
namespace {

// The text in both environments of `hot`.
nlohmann::json Explained(const std::string& text) {
  auto cold = test::Grow(text, Environment{{0}});
  auto hot = test::Grow(text, Environment{{1}});
  ExplainedRobot robot{"the robot",
                       cold.source,
                       cold.mapped.program.genotype,
                       cold.mapped.map,
                       {}};
  robot.environments.push_back(
      {"cold", "hot=False", cold.environment, std::move(cold.history)});
  robot.environments.push_back(
      {"hot", "hot=True", hot.environment, std::move(hot.history)});
  std::vector<ExplainedRobot> robots;
  robots.push_back(std::move(robot));
  return nlohmann::json::parse(ExplainJson(robots))["robots"][0];
}

TEST_CASE("a page has the genotype with its places", "[explain_json]") {
  const nlohmann::json robot = Explained(test::kTwoGenerations);
  CHECK(robot["title"] == "the robot");
  CHECK(robot["file"] == "robot.pls");
  CHECK(robot["axiom"] == "C");
  const std::string text = robot["text"];
  CHECK(text == test::kTwoGenerations);
  REQUIRE(robot["rules"].size() == 4);
  const nlohmann::json& rule = robot["rules"][1];
  CHECK(rule["head"] == "C");
  CHECK(rule["line"] == 4);
  CHECK(rule["terms"] == nlohmann::json{"hot = True"});
  CHECK(rule["connectives"].empty());
  const nlohmann::json& symbol = rule["symbols"][2];
  CHECK(symbol["text"] == "T(0.5)");
  CHECK(symbol["name"] == "T");
  const std::size_t begin = symbol["span"][0];
  const std::size_t end = symbol["span"][1];
  CHECK(text.substr(begin, end - begin) == "T(0.5)");
}

TEST_CASE("a page has what each environment made of it", "[explain_json]") {
  const nlohmann::json robot = Explained(test::kTwoGenerations);
  const nlohmann::json& cold = robot["environments"][0];
  const nlohmann::json& hot = robot["environments"][1];
  CHECK(cold["name"] == "cold");
  CHECK(cold["senses"] == "hot=False");
  CHECK(cold["rules"][1] ==
        nlohmann::json::parse(R"({"active":false,"terms":[false]})"));
  CHECK(hot["rules"][1] ==
        nlohmann::json::parse(R"({"active":true,"terms":[true]})"));
  CHECK(cold["rules"][0] ==
        nlohmann::json::parse(R"({"active":true,"terms":[]})"));
  // C / C B / C B add_front A1 mutate_amp
  CHECK(cold["steps"] == nlohmann::json::parse("[[1],[2,3],[4,5,6,7,8]]"));
  CHECK(cold["insertions"][0] == nlohmann::json::parse("[0,0,0,0]"));
  CHECK(cold["insertions"][6] == nlohmann::json::parse("[3,2,2,3]"));
  REQUIRE(cold["events"].size() == 5);
  CHECK(cold["events"][1]["expressed"] == false);
  CHECK(cold["events"][3]["partner"] == 3);
  const nlohmann::json& joint = cold["modules"][1];
  CHECK(joint["id"] == "2");
  CHECK(joint["type"] == "A1");
  CHECK(joint["origin"] == 4);
  CHECK(joint["y"] == 1);
  CHECK(joint["is_root"] == false);
  CHECK(cold["nodes"][0]["origin"] == 4);
  CHECK(cold["nodes"][0]["changes"] == nlohmann::json{5});
  CHECK(cold["nodes"][0]["amplitude"] == 3.0);
  CHECK(cold["edges"].empty());
}

TEST_CASE("a page marks what differs from the first environment",
          "[explain_json]") {
  const nlohmann::json robot = Explained(
      "plsc 1 genotype robot alphabet plasticoding 1\n"
      "sense hot: bool iterations 1\n"
      "rule C -> { C add_left B add_right A1(0,1,1,1) }\n"
      "rule C -> if hot = False then { C add_front B }\n"
      "rule C -> if hot = True then { C move_left add_left T(0.5) "
      "loop(0.2)}\n");
  const nlohmann::json& cold = robot["environments"][0];
  const nlohmann::json& hot = robot["environments"][1];
  for (const nlohmann::json& module : cold["modules"])
    CHECK(module["mark"] == "shared");
  CHECK(cold["missing"].empty());
  REQUIRE(hot["modules"].size() == 4);
  CHECK(hot["modules"][1]["mark"] == "shared");
  const nlohmann::json& sensor = hot["modules"][3];
  CHECK(sensor["id"] == "2s3");
  CHECK(sensor["mark"] == "new");
  // In its parent's cell, at the side that it faces: left of left is back.
  CHECK(sensor["x"] == -1);
  CHECK(sensor["facing"] == 2);
  REQUIRE(hot["missing"].size() == 1);
  CHECK(hot["missing"][0]["y"] == 1);
  REQUIRE(hot["edges"].size() == 2);
  CHECK(hot["edges"][0]["origin"] == 8);
  CHECK(hot["edges"][1]["origin"] == 9);
  CHECK(hot["edges"][1]["source"] == hot["edges"][1]["destination"]);
}

}  // namespace
}  // namespace plsc
