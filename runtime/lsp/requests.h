#pragma once

// The one table of the requests that are about documents: method to feature.

#include <string_view>

#include "runtime/lsp/json.h"
#include "runtime/lsp/workspace.h"

namespace plsc::lsp {

/// The result of a request; throws a Fault when there is none.
using Serve = Json (*)(Workspace& workspace, const Json& params);

/// nullptr when there is no such request.
Serve FindRequest(std::string_view method);

}  // namespace plsc::lsp
