#include "runtime/lsp/capabilities.h"

#include <catch2/catch.hpp>

#include "runtime/lsp/requests.h"

namespace plsc::lsp {

TEST_CASE("What the server says it can, it serves", "[lsp]") {
  const Json can = InitializeResult("1.2.3")["capabilities"];
  const std::vector<std::pair<const char*, const char*>> providers = {
      {"hoverProvider", "textDocument/hover"},
      {"definitionProvider", "textDocument/definition"},
      {"referencesProvider", "textDocument/references"},
      {"documentHighlightProvider", "textDocument/documentHighlight"},
      {"documentSymbolProvider", "textDocument/documentSymbol"},
      {"documentFormattingProvider", "textDocument/formatting"},
      {"documentRangeFormattingProvider", "textDocument/rangeFormatting"},
      {"foldingRangeProvider", "textDocument/foldingRange"},
      {"signatureHelpProvider", "textDocument/signatureHelp"},
      {"inlayHintProvider", "textDocument/inlayHint"},
      {"renameProvider", "textDocument/prepareRename"},
      {"completionProvider", "textDocument/completion"},
      {"codeActionProvider", "textDocument/codeAction"},
      {"semanticTokensProvider", "textDocument/semanticTokens/range"},
      {"executeCommandProvider", "workspace/executeCommand"},
  };
  for (const auto& [provider, method] : providers) {
    INFO(provider);
    CHECK(can.contains(provider));
    CHECK(FindRequest(method) != nullptr);
  }
  CHECK(can["textDocumentSync"]["change"] == 2);
  CHECK(InitializeResult("1.2.3")["serverInfo"]["version"] == "1.2.3");
}

TEST_CASE("What a client does not say it cannot", "[lsp]") {
  const ClientFeatures none = FeaturesOf(Json::object());
  CHECK_FALSE(none.has_snippets);
  CHECK_FALSE(none.has_nested_symbols);
  CHECK_FALSE(none.can_refresh_hints);
  const ClientFeatures odd =
      FeaturesOf({{"capabilities", {{"textDocument", {{"completion", 7}}}}}});
  CHECK_FALSE(odd.has_snippets);
  const ClientFeatures all = FeaturesOf(Json::parse(R"({"capabilities": {
      "workspace": {"inlayHint": {"refreshSupport": true}},
      "textDocument": {
        "completion": {"completionItem": {"snippetSupport": true}},
        "documentSymbol": {"hierarchicalDocumentSymbolSupport": true}}}})"));
  CHECK(all.has_snippets);
  CHECK(all.has_nested_symbols);
  CHECK(all.can_refresh_hints);
}

}  // namespace plsc::lsp
