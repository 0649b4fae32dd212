#pragma once

// The command that editors start.

#include <string>

#include "runtime/cli/files/io.h"

namespace plsc::cli {

class Options;

/// What some clients say to every server; nothing depends on it.
struct LspCommand {
  bool stdio = true;
  std::string client_process_id;
};
void Add(Options& options, LspCommand& command);
Exit Run(const LspCommand& command, Io& io);

}  // namespace plsc::cli
