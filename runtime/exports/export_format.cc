#include "runtime/exports/export_format.h"

#include <cassert>

#include "runtime/exports/controller_header.h"
#include "runtime/exports/controller_json.h"
#include "runtime/exports/mjcf.h"
#include "runtime/exports/robot_json.h"
#include "runtime/exports/robot_yaml.h"
#include "runtime/exports/sdf.h"
#include "runtime/exports/urdf.h"

namespace plsc {

std::string_view EndingOf(ExportFormat format) {
  for (const FormatNames& one : kExportFormats)
    if (one.format == format) return one.ending;
  assert(false);
  return "";
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
