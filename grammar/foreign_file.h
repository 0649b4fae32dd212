#pragma once

// Is this a genotype, but in another program's notation? The authors' program
// (Revolve) writes its genotypes as one line of Python or as lines of its own
// tokens; either would give many syntax errors that miss the point.

#include <optional>

#include "grammar/diagnostic.h"

namespace plsc {

/// P5012 for a text in the notation of Revolve, or nothing.
std::optional<Diagnostic> DescribeForeignFile(std::string_view text);

}  // namespace plsc
