#pragma once

// SVG to PNG, by librsvg and cairo. They are loaded when a picture is asked
// for: they and what they need would cost each start of plsc some 20 ms, and
// who needs no PNG need not install them. Their headers are needed when plsc is
// built; without them there are no PNGs (no_png.cc).

#include <string>

#include "grammar/expected.h"
#include "grammar/failure.h"

namespace plsc::cli {

/// Names that the loader knows; others are for tests.
struct PngLibraries {
  std::string rsvg = "librsvg-2.so.2";
  std::string cairo = "libcairo.so.2";
  std::string gobject = "libgobject-2.0.so.0";
};

/// The bytes of a PNG of `scale` pixels per px of the SVG; or what is missing.
Expected<std::string, Failure> PngOf(const std::string& svg, double scale,
                                     const PngLibraries& libraries = {});

}  // namespace plsc::cli
