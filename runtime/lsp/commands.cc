#include "runtime/lsp/commands.h"

#include <fmt/format.h>

#include <string>
#include <unordered_set>
#include <vector>

#include "runtime/lsp/chosen_environment.h"
#include "runtime/lsp/params.h"
#include "runtime/lsp/rpc.h"

namespace plsc::lsp {

namespace {

// The first argument, if there is one; all of ours are strings.
std::string FirstArgument(const Json& params) {
  const auto arguments = params.find("arguments");
  if (arguments == params.end() || arguments->is_null()) return "";
  if (!arguments->is_array())
    throw Fault(ErrorCode::kInvalidParams,
                "expected 'arguments' to be an array");
  if (arguments->empty()) return "";
  if (!arguments->front().is_string())
    throw Fault(ErrorCode::kInvalidParams,
                "expected the first argument to be a string");
  return arguments->front().get<std::string>();
}

bool IsKnownSomewhere(Workspace& workspace, const std::string& environment) {
  if (environment.empty() || workspace.documents.all().empty()) return true;
  for (auto& [uri, document] : workspace.documents.all())
    for (const Section& section : document.analysis->sections())
      if (ChosenFor(section, environment)) return true;
  return false;
}

Json Choose(Workspace& workspace, const std::string& environment) {
  if (!IsKnownSomewhere(workspace, environment))
    throw Fault(ErrorCode::kRequestFailed,
                fmt::format("no open genotype has an environment '{}'; write "
                            "its name, or STATE=VALUE,... for every state",
                            environment));
  if (TakeSettings({{"environment", environment}}, &workspace))
    workspace.RefreshHints();
  return nullptr;
}

Json List(Workspace& workspace, const std::string& uri) {
  Document* document = workspace.documents.Find(uri);
  if (document == nullptr)
    throw Fault(ErrorCode::kInvalidParams,
                fmt::format("no document '{}' is open", uri));
  std::vector<std::string> names;
  std::unordered_set<std::string> known;
  for (const Section& section : document->analysis->sections())
    for (const NamedEnvironment& one : EnvironmentsOf(section))
      if (known.insert(one.name).second) names.push_back(one.name);
  return names;
}

}  // namespace

Json ExecuteCommand(Workspace& workspace, const Json& params) {
  const std::string& command = ReadString(params, "command");
  const std::string argument = FirstArgument(params);
  if (command == kChooseEnvironment) return Choose(workspace, argument);
  if (command == kListEnvironments) return List(workspace, argument);
  throw Fault(ErrorCode::kInvalidParams,
              fmt::format("there is no command '{}'", command));
}

}  // namespace plsc::lsp
