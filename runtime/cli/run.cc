#include "runtime/cli/run.h"

#include <ostream>

#include "runtime/cli/arguments/arguments.h"

namespace plsc::cli {

Exit Main(const std::vector<std::string>& arguments, Io& io) {
  const Exit exit = ParseArguments(arguments).Execute(io);
  if (exit == Exit::kBadInput || exit == Exit::kBadUsage)
    io.err << AdviceOnValues(arguments);
  return exit;
}

}  // namespace plsc::cli
