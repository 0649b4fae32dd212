#pragma once

// Manual pages, made of the description of the command line: roff for `man`.

#include <string>
#include <string_view>

#include "runtime/cli/arguments/command_description.h"

namespace plsc::cli {

/// "plsc-study-run", of plsc itself "plsc".
std::string PageName(const CommandDescription& command);

/// The page of section 1; `version` is plsc's.
std::string ManPage(const CommandDescription& command,
                    std::string_view version);

}  // namespace plsc::cli
