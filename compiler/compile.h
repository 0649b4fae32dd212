#pragma once

// From text to IR in one call: parse, resolve, check, lower, verify. Pure: no
// files, no clock, no randomness.

#include <string>
#include <vector>

#include "compiler/compile_options.h"
#include "compiler/program.h"
#include "compiler/source_map.h"
#include "grammar/result.h"
#include "grammar/source.h"

namespace plsc {

struct MappedProgram {
  Program program;
  SourceMap map;  ///< where in the text each part was written
};

/// As many errors as can be found, sorted by position; or the programs, one a
/// genotype in file order, at least one, with their warnings.
Result<std::vector<Program>> CompileAll(const Source& source,
                                        const CompileOptions& options = {});
Result<std::vector<MappedProgram>> CompileAllWithMap(
    const Source& source, const CompileOptions& options = {});

/// The same of a file of one genotype; P2019 when there are several.
Result<Program> Compile(const Source& source,
                        const CompileOptions& options = {});
Result<MappedProgram> CompileWithMap(const Source& source,
                                     const CompileOptions& options = {});

/// P2019 of a file that names several.
Diagnostic SeveralGenotypes(const Source& source);

}  // namespace plsc
