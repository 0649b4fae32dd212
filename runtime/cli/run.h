#pragma once

#include <string>
#include <vector>

#include "runtime/cli/files/io.h"

namespace plsc::cli {

/// The whole program, as tests call it; `arguments` without its name.
Exit Main(const std::vector<std::string>& arguments, Io& io);

}  // namespace plsc::cli
