#pragma once

// Scripts that complete plsc's commands in shells, made of the description of
// the command line. They need nothing but the shell itself.

#include <string>

#include "runtime/cli/arguments/command_description.h"
#include "runtime/cli/arguments/shell.h"

namespace plsc::cli {

std::string CompletionScript(const CommandDescription& root, Shell shell);

}  // namespace plsc::cli
