#include <fmt/format.h>

#include <ostream>

#include "runtime/cli/commands.h"

namespace plsc::cli {

Exit Run(const ViewCommand& command, Io& io) {
  io.err << fmt::format("{}: not yet\n", command.output);
  return Exit::kBadInput;
}

}  // namespace plsc::cli
