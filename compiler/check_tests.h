#pragma once

// What is wrong with inline tests whose names are found: the environment, the
// iteration, and bodies that no development can give.

#include <vector>

#include "compiler/resolve.h"

namespace plsc {

std::vector<Diagnostic> CheckTests(const ast::File& file, const Scope& scope,
                                   const Resolution& resolution);

}  // namespace plsc
