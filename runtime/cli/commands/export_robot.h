#pragma once

// The half of `plsc export` that writes robots: each environment's as a file
// in the format of another program.

#include "runtime/cli/arguments/exports.h"

namespace plsc::cli {

/// `command.to` says which format.
Exit ExportRobots(const ExportCommand& command, Io& io);

/// "climber.flat.xml": of any names, what every file system takes. `taken`
/// are not given again.
std::string ExportedName(const RobotModel& model, ExportFormat format,
                         const std::vector<std::string>& taken);

}  // namespace plsc::cli
