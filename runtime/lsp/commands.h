#pragma once

// workspace/executeCommand.

#include "runtime/lsp/json.h"
#include "runtime/lsp/workspace.h"

namespace plsc::lsp {

/// Arguments: the environment of inlay hints (a name, or STATE=VALUE,...); none
/// or "" for each genotype's first.
inline constexpr const char* kChooseEnvironment = "plsc.chooseEnvironment";
/// Arguments: a document's URI. The names of its environments.
inline constexpr const char* kListEnvironments = "plsc.listEnvironments";

Json ExecuteCommand(Workspace& workspace, const Json& params);

}  // namespace plsc::lsp
