#pragma once

// The robot that a command is asked for: of a genotype file, or of a run, whose
// seasons are the environments. Either way its text, so that rules and symbols
// have places.

#include <optional>
#include <string>
#include <vector>

#include "grammar/expected.h"
#include "runtime/cli/files/io.h"
#include "runtime/cli/files/load_program.h"
#include "runtime/evolve/individual.h"
#include "runtime/scenario/scenario.h"

namespace plsc::cli {

struct RobotAsked {
  std::string file;        ///< a genotype file or the store of a run
  std::string individual;  ///< of a run, an id or "best"; else empty
  std::vector<std::string> environments;  ///< as DevelopCommand's
  bool allow_range = false;
  /// A file, whose seasons are the environments; empty: the run's scenario, or
  /// none.
  std::string scenario = {};
  std::optional<EngineKind> engine = {};  ///< of the scenario's seasons
};

struct RobotFound {
  std::string title;  ///< "climber", "robot_12 of generation 3"
  LoadedProgram loaded;
  std::vector<NamedEnvironment> environments;  ///< one at least
  /// Of the run, or asked for; the program's environments are its seasons then.
  std::optional<Scenario> scenario = {};
};

/// Of the built-in alphabet. Prints what is wrong, which is also the exit
/// status. Without `environments`: all of the file, or all seasons that the
/// robot lived to develop in.
Expected<RobotFound, Exit> FindRobot(const RobotAsked& asked, Io& io);

/// Somebody of a run, and how it lives there: its first life of several.
struct RobotOfRun {
  Individual individual;
  Scenario scenario;
};
/// By an id or "best". Prints what is wrong.
Expected<RobotOfRun, Exit> FindInStore(const std::string& run,
                                       const std::string& individual, Io& io);

/// False if the file is a run and nobody of it is named, which is said.
bool IsRobotNamed(const std::string& file, const std::string& individual,
                  Io& io);

/// Whether the genotype has a body to simulate and every season says what it
/// senses and cannot feel. Prints what is wrong.
bool CanLive(const Scenario& scenario, const Genotype& genotype, Io& io);

}  // namespace plsc::cli
