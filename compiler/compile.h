#pragma once

// From text to IR in one call: parse, resolve, check, lower, verify. Pure: no
// files, no clock, no randomness.

#include "compiler/program.h"
#include "compiler/source_map.h"
#include "grammar/result.h"
#include "grammar/source.h"

namespace plsc {

struct CompileOptions {
  /// Arguments outside their declared range become warnings (P2004).
  bool allow_out_of_range = false;
};

/// As many errors as can be found, sorted by position; or the program, with
/// its warnings.
Result<Program> Compile(const Source& source,
                        const CompileOptions& options = {});

struct MappedProgram {
  Program program;
  SourceMap map;
};

/// The same, and where in the text each part was written.
Result<MappedProgram> CompileWithMap(const Source& source,
                                     const CompileOptions& options = {});

}  // namespace plsc
