#include <ostream>
#include <variant>

#include "runtime/cli/commands.h"

namespace plsc::cli {

Exit Run(const Answer& answer, Io& io) {
  io.out << answer.out;
  io.err << answer.err;
  return answer.exit;
}

Exit Main(const std::vector<std::string>& arguments, Io& io) {
  return std::visit([&](const auto& command) { return Run(command, io); },
                    ParseArguments(arguments));
}

}  // namespace plsc::cli
