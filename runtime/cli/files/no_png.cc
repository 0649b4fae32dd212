#include "runtime/cli/files/png.h"

namespace plsc::cli {

Expected<std::string, Failure> PngOf(const std::string& /*svg*/,
                                     double /*scale*/,
                                     const PngLibraries& /*libraries*/) {
  return Failure(
      "cannot make a PNG: this plsc was built without librsvg; write an .svg, "
      "of which rsvg-convert or a browser makes a PNG");
}

}  // namespace plsc::cli
