#pragma once

// The robot that a command about pictures is asked for: of a genotype file, or
// of a run, whose seasons are the environments. Either way its text, so that
// rules and symbols have places.

#include <string>
#include <variant>
#include <vector>

#include "runtime/cli/io.h"
#include "runtime/cli/program.h"

namespace plsc::cli {

struct RobotAsked {
  std::string file;        ///< a genotype file or the store of a run
  std::string individual;  ///< of a run, an id or "best"; else empty
  std::vector<std::string> environments;  ///< as DevelopCommand's
  bool allow_range = false;
};

struct RobotFound {
  std::string title;  ///< "climber", "robot_12 of generation 3"
  LoadedProgram loaded;
  std::vector<NamedEnvironment> environments;  ///< one at least
};

/// Of the built-in alphabet. Prints what is wrong, which is also the exit
/// status. Without `environments`: all of the file, or all seasons that the
/// robot lived to develop in.
std::variant<RobotFound, Exit> FindRobot(const RobotAsked& asked, Io& io);

/// What is sensed, unless the name says it.
std::string SensesOf(const NamedEnvironment& named,
                     const std::vector<State>& states);

}  // namespace plsc::cli
