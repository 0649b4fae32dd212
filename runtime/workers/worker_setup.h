#pragma once

// Workers that are forked before the run is known: each request carries a text
// that tells of the run, and what a worker makes of it is kept for the next. A
// few kilobytes more a request, and no order in which things must come.

#include <functional>
#include <string>

#include "runtime/workers/workers.h"

namespace plsc {

/// What workers do in the run that `setup` tells of.
using MakeWork = std::function<Work(const std::string& setup)>;

/// Answers requests of RequestWithSetup as the work made of their setup does.
Work WorkWithSetup(MakeWork make_work);

std::string RequestWithSetup(const std::string& setup,
                             const std::string& request);

}  // namespace plsc
