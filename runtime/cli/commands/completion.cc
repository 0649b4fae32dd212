#include <ostream>

#include "runtime/cli/arguments/command_description.h"
#include "runtime/cli/arguments/completion_script.h"
#include "runtime/cli/arguments/shell.h"

namespace plsc::cli {

Exit Run(const CompletionCommand& command, Io& io) {
  io.out << CompletionScript(DescribeCommandLine(), command.shell);
  return Exit::kFine;
}

}  // namespace plsc::cli
