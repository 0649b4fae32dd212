#pragma once

// The body from above in Unicode box characters, for a terminal.

#include <string>

#include "runtime/pictures/body_shapes.h"
#include "sim/body.h"

namespace plsc {

/// One box a module with its symbol and number, the core's front up; a dot
/// where a module hangs on its parent, T where a touch sensor sits. Lines end
/// in a newline and carry no trailing blanks.
std::string BodyText(const Body& body);

/// The same with what differs from the reference: thick lines where that has no
/// module, double ones where it has another, an empty dashed box where only it
/// has one and the cell is free; small t a sensor that only it has.
/// As many rows of cells as `rows` has.
std::string BodyText(const Body& body, const Body& reference,
                     const CellExtent& rows);

}  // namespace plsc
