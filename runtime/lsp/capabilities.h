#pragma once

// What server and client say of themselves in `initialize`.

#include <string>

#include "runtime/lsp/json.h"
#include "runtime/lsp/workspace.h"

namespace plsc::lsp {

/// From params of `initialize`; what is not said cannot be done.
ClientFeatures FeaturesOf(const Json& params);

/// The result of `initialize`.
Json InitializeResult(const std::string& version);

}  // namespace plsc::lsp
