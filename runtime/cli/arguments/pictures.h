#pragma once

// The command that makes pictures.

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/cli/files/io.h"

namespace plsc::cli {

class Options;

/// What a module's colour tells.
enum class ColourBy : std::uint8_t { kType, kRule };

struct DrawCommand {
  std::string file;        ///< a genotype file, or the store of a run
  std::string individual;  ///< of a run: an id or "best"; else empty
  std::vector<std::string> environments;  ///< as DevelopCommand's
  bool brain = false;
  ColourBy colour = ColourBy::kType;
  std::string output;  ///< an .svg or .png; empty: the terminal
  bool force = false;  ///< as Output::force
  double scale = 2;    ///< pixels of a PNG per px of the SVG
  bool terminal = false;
  bool allow_range = false;
};
void Add(Options& options, DrawCommand& command);
Exit Run(const DrawCommand& command, Io& io);

}  // namespace plsc::cli
