#pragma once

// The formats in which a robot leaves plsc, by name.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "runtime/exports/surroundings.h"

namespace plsc {

struct RobotModel;

enum class ExportFormat : std::uint8_t {
  kMjcf,
  kUrdf,
  kSdf,
  kYaml,
  kJson,
  kControllerJson,
  kControllerC,
};

struct FormatNames {
  ExportFormat format = ExportFormat::kMjcf;
  std::string_view name;    ///< "mjcf", as one asks for it
  std::string_view ending;  ///< of its files, without the dot
};
inline constexpr std::array<FormatNames, 7> kExportFormats{
    {{ExportFormat::kMjcf, "mjcf", "xml"},
     {ExportFormat::kUrdf, "urdf", "urdf"},
     {ExportFormat::kSdf, "sdf", "sdf"},
     {ExportFormat::kYaml, "yaml", "yaml"},
     {ExportFormat::kJson, "json", "json"},
     {ExportFormat::kControllerJson, "controller-json", "controller.json"},
     {ExportFormat::kControllerC, "controller-c", "h"}}};

std::string_view NameOf(ExportFormat format);
std::string_view EndingOf(ExportFormat format);

/// What of the robot's world and constants a file of that format, with a
/// floor, leaves out although they are not the default profile's: "the ground,
/// gravity". Empty if nothing; brains alone have no world.
std::string LeftOut(ExportFormat format, const RobotModel& model);

/// Whether its files name parts, which a prefix can go before.
bool HasNames(ExportFormat format);

/// The whole file. Surroundings matter to MJCF and SDFormat.
std::string ExportText(ExportFormat format, const RobotModel& model,
                       Surroundings surroundings);

}  // namespace plsc
