#pragma once

// The oscillators of a robot as JSON, with the formulas that drive its servos,
// so that the brain runs elsewhere. runtime/exports/controller_header is the
// same as code.

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace plsc {

struct RobotModel;

/// Keys: plsc_controller (version of this layout), robot, environment, joints,
/// inputs, oscillators, edges, servo, formulas (docs/exports.md).
std::string ControllerJson(const RobotModel& model);

/// The same as a value, for other documents that hold it.
nlohmann::ordered_json ControllerValue(const RobotModel& model);

/// Objects on lines of their own, two blanks a level; arrays of numbers and
/// texts on one line.
std::string ReadableJson(const nlohmann::ordered_json& value);

}  // namespace plsc
