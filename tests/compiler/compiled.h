#pragma once

// Programs from text, for tests of what comes after compiling.

#include <string>

#include "compiler/program.h"

namespace plsc::testing {

/// Fails the test with the diagnostics if `text` does not compile.
Program Compiled(const std::string& text);

/// The codes of the diagnostics of `text`, by position: "P2001 W3002".
std::string CodesOf(const std::string& text);

}  // namespace plsc::testing
