#pragma once

// The command that writes files for other programs.

#include <optional>
#include <string>
#include <vector>

#include "runtime/cli/files/io.h"
#include "runtime/exports/export_format.h"
#include "sim/options.h"

namespace plsc::cli {

class Options;

struct ExportCommand {
  std::string file;        ///< the store of a run; a genotype file for `to`
  std::string csv_folder;  ///< empty: none
  bool jsonl = false;
  std::optional<ExportFormat> to;         ///< a robot instead of the run
  std::string individual;                 ///< of `to`; as RobotAsked's
  std::vector<std::string> environments;  ///< of `to`; as DevelopCommand's
  std::string scenario;                   ///< of `to`, as RobotAsked's
  std::optional<EngineKind> engine;       ///< of `to`, as SimulateCommand's
  bool alone = false;                     ///< of `to`: without floor
  std::string prefix;                     ///< of `to`: before names of parts
  bool allow_range = false;               ///< of `to`
  /// Of --jsonl or --to; empty: standard output. A folder if there are several
  /// environments.
  std::string output;
  bool force = false;  ///< as Output::force
};
void Add(Options& options, ExportCommand& command);
Exit Run(const ExportCommand& command, Io& io);

}  // namespace plsc::cli
