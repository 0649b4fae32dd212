#pragma once

// The body from above as SVG, in the style of the paper's figures: the core's
// front up, one square a module, sensors as bars on the side that they sense.

#include <string>

#include "sim/body.h"

namespace plsc {

/// A complete SVG file. `title` is shown above the body and may hold any text.
std::string BodySvg(const Body& body, const std::string& title);

}  // namespace plsc
