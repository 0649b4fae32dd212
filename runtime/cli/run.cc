#include <ostream>
#include <variant>

#include "runtime/cli/arguments/command.h"

namespace plsc::cli {

Exit Run(const Answer& answer, Io& io) {
  io.out << answer.out;
  io.err << answer.err;
  return answer.exit;
}

Exit Main(const std::vector<std::string>& arguments, Io& io) {
  const Exit exit =
      std::visit([&](const auto& command) { return Run(command, io); },
                 ParseArguments(arguments));
  if (exit == Exit::kBadInput || exit == Exit::kBadUsage)
    io.err << AdviceOnValues(arguments);
  return exit;
}

}  // namespace plsc::cli
