#include "runtime/lsp/requests.h"

#include <catch2/catch.hpp>

#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

TEST_CASE("Only known requests are served", "[lsp]") {
  CHECK(FindRequest("textDocument/hover") != nullptr);
  CHECK(FindRequest("textDocument/Hover") == nullptr);
  CHECK(FindRequest("") == nullptr);
}

TEST_CASE("Every request answers about an open document", "[lsp]") {
  Editor editor;
  editor.Open(kGecko);
  const auto offset =
      static_cast<std::uint32_t>(std::string(kGecko).find("mild"));
  for (const char* method :
       {"textDocument/hover", "textDocument/definition",
        "textDocument/documentHighlight", "textDocument/references",
        "textDocument/completion", "textDocument/prepareRename",
        "textDocument/signatureHelp"}) {
    INFO(method);
    CHECK_FALSE(editor.Ask(method, editor.HereAt(offset)).contains("error"));
  }
  for (const char* method :
       {"textDocument/documentSymbol", "textDocument/formatting",
        "textDocument/foldingRange", "textDocument/semanticTokens/full"}) {
    INFO(method);
    CHECK_FALSE(editor.Ask(method, editor.Here()).contains("error"));
  }
  for (const char* method :
       {"textDocument/codeAction", "textDocument/inlayHint",
        "textDocument/rangeFormatting", "textDocument/semanticTokens/range"}) {
    INFO(method);
    CHECK_FALSE(editor.Ask(method, editor.Whole()).contains("error"));
  }
  Json rename = editor.HereAt(offset);
  rename["newName"] = "warm";
  CHECK(editor.Result("textDocument/rename", rename)["changes"][kTestUri]
            .size() == 3);
}

}  // namespace plsc::lsp
