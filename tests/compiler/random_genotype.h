#pragma once

// Random programs that pass Verify, for properties of printing, compiling and
// formatting. Wilder than the evolver's: any alphabet, any kind of state, and
// numbers from all over the doubles.

#include <cstdint>
#include <functional>

#include "compiler/program.h"

namespace plsc::testing {

/// The same program for the same seed.
Program RandomProgram(std::uint32_t seed);

/// Where choices come from: a number of which only the remainder by `most` + 1
/// matters.
using Draw = std::function<std::uint32_t(std::uint32_t most)>;
/// The program of those choices. Ends for every `draw` that gives zeros after
/// some time.
Program RandomProgram(const Draw& draw);

}  // namespace plsc::testing
