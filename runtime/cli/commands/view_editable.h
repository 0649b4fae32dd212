#pragma once

// `plsc view --editable`: the page of `plsc live` as one file, which has the
// compiler and the simulator in it and is joined with nothing.

#include "runtime/cli/arguments/view.h"

namespace plsc::cli {

Exit MakeEditable(const ViewCommand& command, Io& io);

}  // namespace plsc::cli
