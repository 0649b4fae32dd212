#include "runtime/lsp/capabilities.h"

#include "runtime/lsp/commands.h"
#include "runtime/lsp/params.h"
#include "runtime/lsp/semantic_tokens.h"

namespace plsc::lsp {

namespace {

// LSP's TextDocumentSyncKind: changes say which range they replace.
constexpr int kIncremental = 2;

}  // namespace

ClientFeatures FeaturesOf(const Json& params) {
  ClientFeatures features;
  features.has_snippets =
      IsTrue(params, {"capabilities", "textDocument", "completion",
                      "completionItem", "snippetSupport"});
  features.has_nested_symbols =
      IsTrue(params, {"capabilities", "textDocument", "documentSymbol",
                      "hierarchicalDocumentSymbolSupport"});
  features.can_refresh_hints = IsTrue(
      params, {"capabilities", "workspace", "inlayHint", "refreshSupport"});
  return features;
}

Json InitializeResult(const std::string& version) {
  Json capabilities = {
      {"positionEncoding", "utf-16"},
      {"textDocumentSync", {{"openClose", true}, {"change", kIncremental}}},
      {"hoverProvider", true},
      {"definitionProvider", true},
      {"referencesProvider", true},
      {"documentHighlightProvider", true},
      {"documentSymbolProvider", true},
      {"documentFormattingProvider", true},
      {"documentRangeFormattingProvider", true},
      {"foldingRangeProvider", true},
      {"inlayHintProvider", true},
      {"renameProvider", {{"prepareProvider", true}}}};
  capabilities["completionProvider"]["triggerCharacters"] =
      Json::array({" ", "=", "{", "("});
  capabilities["signatureHelpProvider"]["triggerCharacters"] =
      Json::array({"(", ","});
  capabilities["codeActionProvider"]["codeActionKinds"] =
      Json::array({"quickfix", "source.fixAll.plsc"});
  capabilities["semanticTokensProvider"] = {
      {"legend", SemanticTokensLegend()}, {"full", true}, {"range", true}};
  capabilities["executeCommandProvider"]["commands"] =
      Json::array({kChooseEnvironment, kListEnvironments});
  Json result = {{"serverInfo", {{"name", "plsc"}, {"version", version}}}};
  result["capabilities"] = std::move(capabilities);
  return result;
}

}  // namespace plsc::lsp
