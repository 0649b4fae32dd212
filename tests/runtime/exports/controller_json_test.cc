#include "runtime/exports/controller_json.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "sim/controller.h"
#include "sim/maths/sine.h"
#include "tests/runtime/exports/read_robot.h"
#include "tests/sim/bodies.h"

namespace plsc {
namespace {

using nlohmann::json;

/// The outputs that a reader works out from the file and its formulas alone.
std::vector<double> OutputsOf(const json& file, double time,
                              std::vector<double>& before) {
  const json& oscillators = file["oscillators"];
  std::vector<double> outputs(file["joints"].size(), file["rest_output"]);
  before.resize(oscillators.size(), file["rest_output"]);
  for (std::size_t i = 0; i < oscillators.size(); ++i) {
    const json& one = oscillators[i];
    const double turns =
        time / one["period"].get<double>() - one["phase_offset"].get<double>();
    double output =
        0.5 + one["amplitude"].get<double>() / 2 *
                  Sin(2 * std::numbers::pi * (turns - std::round(turns)));
    for (const json& edge : file["edges"]) {
      if (edge["to_oscillator"] != i) continue;
      const double weight = edge["weight"];
      // All sensors are touched.
      output += edge["from"] == "itself" ? weight * (before[i] - 0.5) : weight;
    }
    before[i] = std::clamp(output, 0.0, 1.0);
    for (std::size_t joint = 0; joint < outputs.size(); ++joint)
      if (file["joints"][joint] == one["joint"]) outputs[joint] = before[i];
  }
  return outputs;
}

TEST_CASE("The controller's JSON is enough to run it", "[controller_json]") {
  for (const RobotModel& model : test::ManyModels()) {
    INFO(model.name);
    const json file = json::parse(ControllerJson(model));
    CHECK(file["plsc_controller"] == 1);
    CHECK(file["robot"] == model.name);
    CHECK(file["controller"] == "coupled");
    Controller controller(model.phenotype, ControllerMode::kCoupled);
    const std::vector<bool> touched(model.phenotype.body.modules.size(), true);
    std::vector<double> before;
    for (int update = 0; update < 20; ++update) {
      const double time = update / file["servo"]["update_rate"].get<double>();
      // Equal, not near: numbers come back bit for bit.
      CHECK(OutputsOf(file, time, before) == controller.Update(time, touched));
    }
  }
}

TEST_CASE("The servo's constants are those of the simulation",
          "[controller_json]") {
  const RobotModel model = test::ModelOfBody(Cross(), "cross");
  const json servo = json::parse(ControllerJson(model))["servo"];
  const ServoOptions& ours = model.options.servo;
  CHECK(servo["range"] == ours.range);
  CHECK(servo["gain"] == ours.gain);
  CHECK(servo["max_speed"] == ours.max_speed);
  CHECK(servo["max_torque"] == ours.max_torque);
  CHECK(servo["min_output"] == kMinOutput);
  CHECK(servo["max_output"] == kMaxOutput);
}

TEST_CASE("JSON for people has an object's keys on lines",
          "[controller_json]") {
  const nlohmann::ordered_json value = {
      {"a", 1},
      {"b", {1.5, 2}},
      {"c", {{"d", "x"}}},
      {"e", nlohmann::ordered_json::array({{{"f", 1}}})},
      {"g", nlohmann::ordered_json::array()},
      {"h", nlohmann::ordered_json::object()}};
  CHECK(ReadableJson(value) ==
        "{\n"
        "  \"a\": 1,\n"
        "  \"b\": [1.5,2],\n"
        "  \"c\": {\n"
        "    \"d\": \"x\"\n"
        "  },\n"
        "  \"e\": [\n"
        "    {\n"
        "      \"f\": 1\n"
        "    }\n"
        "  ],\n"
        "  \"g\": [],\n"
        "  \"h\": {}\n"
        "}\n");
}

}  // namespace
}  // namespace plsc
