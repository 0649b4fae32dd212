#pragma once

// The body from above in Unicode box characters, for a terminal.

#include <string>

#include "sim/body.h"

namespace plsc {

/// One box a module with its symbol and number, the core's front up; a dot
/// where a module hangs on its parent, T where a touch sensor sits. Lines end
/// in a newline and carry no trailing blanks.
std::string BodyText(const Body& body);

}  // namespace plsc
