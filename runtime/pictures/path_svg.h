#pragma once

// Where a robot went, as one SVG: the seasons side by side, seen from straight
// above, +y (uphill) up, at one scale unless that makes one a speck. The path
// of the mass centre, light at first and dark at last, the body at the start as
// outlines and at the end in its colours.

#include <string>

namespace plsc {

struct Recording;

/// A complete SVG file. Names may hold any text.
std::string PathSvg(const Recording& recording);

}  // namespace plsc
