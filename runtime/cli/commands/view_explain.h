#pragma once

// `plsc view --explain`: how genotypes become robots, as a page to point at.
// The replays of `plsc view` are in view.cc.

#include "runtime/cli/arguments/view.h"
#include "runtime/cli/files/output_path.h"

namespace plsc::cli {

/// Of both kinds of pages.
Output PageOf(const ViewCommand& command);

/// Of a ViewCommand with `explain`: its inputs are genotypes.
Exit Explain(const ViewCommand& command, Io& io);

}  // namespace plsc::cli
