#include "runtime/exports/export_format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cassert>
#include <vector>

#include "runtime/exports/controller_header.h"
#include "runtime/exports/controller_json.h"
#include "runtime/exports/exported_ground.h"
#include "runtime/exports/mjcf.h"
#include "runtime/exports/robot_json.h"
#include "runtime/exports/robot_model.h"
#include "runtime/exports/robot_yaml.h"
#include "runtime/exports/sdf.h"
#include "runtime/exports/urdf.h"

namespace plsc {

std::string_view NameOf(ExportFormat format) {
  for (const FormatNames& one : kExportFormats)
    if (one.format == format) return one.name;
  assert(false);
  return "";
}

std::string_view EndingOf(ExportFormat format) {
  for (const FormatNames& one : kExportFormats)
    if (one.format == format) return one.ending;
  assert(false);
  return "";
}

bool HasNames(ExportFormat format) {
  return format != ExportFormat::kYaml;
}

std::string LeftOut(ExportFormat format, const RobotModel& model) {
  static const SimulationOptions usual = ExportedOptions();
  const SimulationOptions& options = model.options;
  const PhysicsOptions& physics = options.physics;
  const bool is_urdf = format == ExportFormat::kUrdf;
  const bool is_yaml = format == ExportFormat::kYaml;
  const bool is_sdf = format == ExportFormat::kSdf;
  std::vector<std::string> parts;
  const auto add = [&](bool is_left_out, std::string what) {
    if (is_left_out) parts.push_back(std::move(what));
  };
  add((is_urdf || is_yaml) && model.terrain.type != TerrainType::kFlat,
      "the " + GroundText(model.terrain));
  add(is_sdf && model.terrain.type == TerrainType::kRough,
      "the hills of the " + GroundText(model.terrain));
  add((is_urdf || is_yaml) && physics.gravity != usual.physics.gravity,
      fmt::format("gravity {} m/s2", physics.gravity));
  add((is_urdf || is_yaml) && physics.step != usual.physics.step,
      fmt::format("step {} s", physics.step));
  add(is_yaml && physics.friction != usual.physics.friction,
      fmt::format("friction {}", physics.friction));
  add(is_yaml && options.servo != usual.servo, "the servo's constants");
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string ExportText(ExportFormat format, const RobotModel& model,
                       Surroundings surroundings) {
  switch (format) {
    case ExportFormat::kMjcf:
      return Mjcf(model, surroundings);
    case ExportFormat::kUrdf:
      return Urdf(model);
    case ExportFormat::kSdf:
      return Sdf(model, surroundings);
    case ExportFormat::kYaml:
      return RobotYaml(model);
    case ExportFormat::kJson:
      return RobotJson(model);
    case ExportFormat::kControllerJson:
      return ControllerJson(model);
    case ExportFormat::kControllerC:
      return ControllerHeader(model);
  }
  assert(false);
  return "";
}

}  // namespace plsc
