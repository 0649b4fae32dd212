#pragma once

// Golden files: what `plsc test` compares with (docs/testing-robots.md has the
// format). One fact a line, so that git shows a change of a robot as changed
// lines, and people can read them.

#include <string>

#include "grammar/result.h"
#include "runtime/compare/golden.h"

namespace plsc {

/// Of the files written here; a reader refuses what is newer.
inline constexpr int kGoldenVersion = 1;

/// Strict: what is not understood is an error at its place.
Result<Golden> ParseGolden(const Source& source);

/// ParseGolden(PrintGolden(g)) == g. Ends in a newline.
std::string PrintGolden(const Golden& golden);

}  // namespace plsc
