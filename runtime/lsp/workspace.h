#pragma once

// What the server knows between two messages: the open documents, what the
// user chose, what the client can do.

#include <string>
#include <vector>

#include "runtime/lsp/documents.h"
#include "runtime/lsp/json.h"

namespace plsc::lsp {

/// The user's, under `plsc` in the editor's settings.
struct Settings {
  std::string environment;  ///< of inlay hints; empty: each genotype's first
  bool lint = true;         ///< advice of Lint, too
};

struct ClientFeatures {
  bool has_snippets = false;
  bool has_nested_symbols = false;
  bool can_refresh_hints = false;
};

struct Workspace {
  Documents documents;
  Settings settings;
  ClientFeatures client;
  int last_request = 0;               ///< id of ours
  std::vector<std::string> outgoing;  ///< bodies that answer no request

  /// Asks the client to ask for its inlay hints again, if it can.
  void RefreshHints();
};

/// Takes what is there of {environment, lint}; the rest keeps its value.
/// Whether anything changed. All documents are told again then.
bool TakeSettings(const Json& json, Workspace* workspace);

}  // namespace plsc::lsp
