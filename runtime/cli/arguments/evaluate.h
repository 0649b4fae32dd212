#pragma once

// The command that works for an optimiser in another program.

#include <optional>
#include <string>

#include "runtime/cli/files/io.h"
#include "sim/options.h"

namespace plsc::cli {

class Options;

struct EvaluateCommand {
  bool is_stdin = false;             ///< the only source there is
  std::string scenario;              ///< empty: the paper's
  std::optional<EngineKind> engine;  ///< of all seasons; nothing: as written
  std::optional<int> jobs;
  bool in_order = false;  ///< answers come in the order of the requests
  bool allow_range = false;
};
void Add(Options& options, EvaluateCommand& command);
Exit Run(const EvaluateCommand& command, Io& io);

}  // namespace plsc::cli
