#include "runtime/lsp/workspace.h"

#include "runtime/lsp/rpc.h"

namespace plsc::lsp {

void Workspace::RefreshHints() {
  if (!client.can_refresh_hints) return;
  outgoing.push_back(
      RequestBody(++last_request, "workspace/inlayHint/refresh", nullptr));
}

bool TakeSettings(const Json& json, Workspace* workspace) {
  if (!json.is_object()) return false;
  Settings taken = workspace->settings;
  const auto environment = json.find("environment");
  if (environment != json.end() && environment->is_string())
    taken.environment = environment->get<std::string>();
  const auto lint = json.find("lint");
  if (lint != json.end() && lint->is_boolean()) taken.lint = lint->get<bool>();

  const bool other_place = taken.environment != workspace->settings.environment;
  const bool other_advice = taken.lint != workspace->settings.lint;
  workspace->settings = taken;
  if (other_advice)
    for (auto& [uri, document] : workspace->documents.all()) {
      document.is_published = false;
      document.advice = {};
    }
  return other_place || other_advice;
}

}  // namespace plsc::lsp
