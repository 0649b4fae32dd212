#pragma once

// Random programs that pass Verify, for properties of printing, compiling and
// formatting. Wilder than the evolver's: any alphabet, any kind of state, and
// numbers from all over the doubles.

#include <cstdint>
#include <random>

#include "compiler/program.h"

namespace plsc::testing {

/// The same program for the same seed.
Program RandomProgram(std::uint32_t seed);

}  // namespace plsc::testing
