#pragma once

// The shapes of a body seen from above, the core's front up: one square a
// module, a dot towards its parent, sensors as bars on the side that they
// sense. What body_svg and bodies_svg put into their pictures; in px, the
// middle of the core's cell at (0, 0), y down.

#include <string>
#include <vector>

#include "runtime/compare/body_difference.h"
#include "sim/body.h"

namespace plsc {

inline constexpr int kCellSide = 100;  ///< px, as in the authors' drawings

/// Drawn as a bar on its parent.
bool IsSensor(const Module& module);

/// Cells that a body takes; sensors take none.
struct CellExtent {
  int left = 0;
  int right = 0;
  int back = 0;
  int front = 0;

  void Include(const Body& body);
  int columns() const { return right - left + 1; }
  int rows() const { return front - back + 1; }
};

/// How one module is painted.
struct ModulePaint {
  std::string fill;
  std::string ink = "#000";  ///< of the text
  std::string note;          ///< in the corner of its square; may be empty
};

/// Paint by type, for every module of the body.
std::vector<ModulePaint> PaintByType(const Body& body);

/// `paints` by module; `outlines` are elements over the squares, below dots and
/// sensors.
std::string BodyShapes(const Body& body, const std::vector<ModulePaint>& paints,
                       const std::string& outlines = "");

/// Outlines for BodyShapes: thick where the reference has no module,
/// thick and dashed where it has another; thin and dotted where only it has
/// one, and the cell is free.
std::string DifferenceShapes(const Body& reference, const Body& body,
                             const BodyDifference& difference);

/// One outline, as legends show it: its middle, half its side, its mark.
std::string MarkShape(int x, int y, int half, ModuleMark mark);
std::string MissingShape(int x, int y, int half);

}  // namespace plsc
