#pragma once

// What must not be lost by writing a result: told before the work that makes
// it, not after.

#include <string>
#include <vector>

#include "runtime/cli/io.h"

namespace plsc::cli {

/// Whether a file can be made or replaced there. An empty path is none, and
/// fine. Refused are folders, devices and pipes, what is in no folder, the
/// command's own `inputs` (paths of which some may be no files) and stores of
/// runs, whatever their name: days of work, and a slip away in
/// `plsc report *.sqlite -o`. Prints what is wrong.
bool CanWrite(const std::string& path, const std::vector<std::string>& inputs,
              Io& io);

}  // namespace plsc::cli
