#pragma once

// What all pictures share, so that a module looks alike in each of them.

#include <string>
#include <string_view>

#include "sim/body.h"

namespace plsc {

/// The authors' colours, a little lighter so that black text can be read.
std::string_view ModuleColour(ModuleType type);

/// For text and attributes of XML; control characters are left out, which XML
/// cannot hold.
std::string EscapeXml(std::string_view text);

}  // namespace plsc
