#pragma once

// The command line as a whole, and what is said of a wrong one.

#include <string>
#include <vector>

#include "runtime/cli/arguments/command.h"
#include "runtime/cli/arguments/registry.h"

namespace plsc::cli {

/// `arguments` without the program's name.
Command ParseArguments(const std::vector<std::string>& arguments,
                       const Registry& registry = Commands());

/// Of a command line that failed: a word that its writer may have meant as one
/// more value of an option, which takes one each time; how to write that.
/// Empty: there is none.
std::string AdviceOnValues(const std::vector<std::string>& arguments,
                           const Registry& registry = Commands());

}  // namespace plsc::cli
