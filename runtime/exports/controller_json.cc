#include "runtime/exports/controller_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "runtime/exports/controller_tables.h"
#include "runtime/exports/robot_model.h"
#include "runtime/scenario/scenario_physics.h"
#include "sim/controller.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

bool IsFlat(const Json& value) {
  if (!value.is_array()) return value.empty() || !value.is_structured();
  return std::all_of(value.begin(), value.end(), [](const Json& one) {
    return !one.is_structured() || (one.is_array() && IsFlat(one));
  });
}

void Append(const Json& value, std::size_t level, std::string& text) {
  if (IsFlat(value)) {
    text += value.dump();
    return;
  }
  const std::string indent(2 * (level + 1), ' ');
  text += value.is_object() ? "{" : "[";
  const char* separator = "\n";
  for (const auto& [key, one] : value.items()) {
    text += separator + indent;
    if (value.is_object()) text += Json(key).dump() + ": ";
    Append(one, level + 1, text);
    separator = ",\n";
  }
  text += "\n" + std::string(2 * level, ' ');
  text += value.is_object() ? "}" : "]";
}

Json OscillatorValue(const RobotModel& model, const TableOscillator& one) {
  return {{"joint", model.joints[one.joint]},
          {"amplitude", one.amplitude},
          {"period", one.period},
          {"phase_offset", one.phase_offset}};
}

Json EdgeValue(const ControllerTables& tables, const TableEdge& edge) {
  Json value;
  value["from"] = edge.is_loop ? "itself" : tables.inputs[edge.input];
  value["to_oscillator"] = edge.oscillator;
  value["weight"] = edge.weight;
  return value;
}

// With the names of the keys beside it.
Json Formulas() {
  return {
      {"oscillation",
       "0.5 + amplitude / 2 * sin(2 pi (time / period - phase_offset))"},
      {"coupled_output",
       "oscillation, plus for each edge onto it, in order: weight * (its own "
       "output at the update before - rest_output) if from itself, weight if "
       "the sensor is touched; then clamped to 0..1"},
      {"open_loop_output", "oscillation"},
      {"target", "-range + 2 range * output clamped to min_output..max_output"},
      {"refresh",
       "exact: at the steps of the simulation nearest to k / update_rate, the "
       "first at birth; late: at the first step that is more than 1 / "
       "update_rate after the update before, joints held until the first"},
      {"speed", "gain * (target - angle) clamped to -max_speed..max_speed"}};
}

}  // namespace

std::string ReadableJson(const Json& value) {
  std::string text;
  Append(value, 0, text);
  return text + "\n";
}

Json ControllerValue(const RobotModel& model) {
  const ControllerTables tables = TablesOf(model);
  const ServoOptions& servo = model.options.servo;
  Json oscillators = Json::array();
  for (const TableOscillator& one : tables.oscillators)
    oscillators.push_back(OscillatorValue(model, one));
  Json edges = Json::array();
  for (const TableEdge& edge : tables.edges)
    edges.push_back(EdgeValue(tables, edge));
  return {{"controller", NameIn(kControllerNames, model.options.controller)},
          {"joints", model.joints},
          {"inputs", tables.inputs},
          {"oscillators", std::move(oscillators)},
          {"edges", std::move(edges)},
          {"rest_output", kRestOutput},
          {"servo",
           {{"update_rate", servo.update_rate},
            {"refresh", NameIn(kRefreshNames, servo.refresh)},
            {"range", servo.range},
            {"min_output", kMinOutput},
            {"max_output", kMaxOutput},
            {"gain", servo.gain},
            {"max_speed", servo.max_speed},
            {"max_torque", servo.max_torque}}},
          {"formulas", Formulas()}};
}

std::string ControllerJson(const RobotModel& model) {
  Json document{{"plsc_controller", 1},
                {"robot", model.name},
                {"environment", model.environment}};
  document.update(ControllerValue(model));
  return ReadableJson(document);
}

}  // namespace plsc
