#pragma once

// A picture of several panels side by side, such as one an environment, with a
// legend below. Knows nothing of what is in them.

#include <string>
#include <vector>

namespace plsc {

/// Elements and the part of the plane that they take, px.
struct Panel {
  std::string title;     ///< above it, any text
  std::string subtitle;  ///< smaller, below the title; may be empty
  std::string svg;
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
};

struct LegendEntry {
  std::string icon;  ///< elements around (0, 0), at most kLegendIcon wide; or
                     ///< nothing
  std::string text;
};
inline constexpr int kLegendIcon = 30;  ///< px

/// A complete SVG file. Panels go into rows of at most four. `style` is CSS for
/// the classes that the panels use.
std::string PanelsSvg(const std::string& title,
                      const std::vector<Panel>& panels,
                      const std::vector<LegendEntry>& legend,
                      const std::string& style);

}  // namespace plsc
