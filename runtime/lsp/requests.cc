#include "runtime/lsp/requests.h"

#include <algorithm>
#include <array>

#include "runtime/lsp/code_actions.h"
#include "runtime/lsp/commands.h"
#include "runtime/lsp/completion.h"
#include "runtime/lsp/folding.h"
#include "runtime/lsp/formatting.h"
#include "runtime/lsp/hover.h"
#include "runtime/lsp/inlay_hints.h"
#include "runtime/lsp/navigation.h"
#include "runtime/lsp/outline.h"
#include "runtime/lsp/params.h"
#include "runtime/lsp/rename.h"
#include "runtime/lsp/semantic_tokens.h"
#include "runtime/lsp/signature_help.h"

namespace plsc::lsp {

namespace {

Analysis& AnalysisOf(Workspace& workspace, const Json& params) {
  return *workspace.documents.At(params).analysis;
}

std::uint32_t OffsetOf(const Analysis& analysis, const Json& params) {
  return analysis.lines().OffsetAt(ReadPlace(params, "position"));
}

Span SpanOf(const Analysis& analysis, const Json& params) {
  const PlaceRange range = ReadRange(params, "range");
  return {analysis.lines().OffsetAt(range.start),
          analysis.lines().OffsetAt(range.end)};
}

Span WholeOf(const Analysis& analysis) {
  return {0, static_cast<std::uint32_t>(analysis.text().size())};
}

// Requests about one place.
template <Json (*Ask)(Analysis&, std::uint32_t)>
Json AtPlace(Workspace& workspace, const Json& params) {
  Analysis& analysis = AnalysisOf(workspace, params);
  return Ask(analysis, OffsetOf(analysis, params));
}

Json ServeReferences(Workspace& workspace, const Json& params) {
  Analysis& analysis = AnalysisOf(workspace, params);
  return References(analysis, OffsetOf(analysis, params),
                    IsTrue(params, {"context", "includeDeclaration"}));
}

Json ServeCompletion(Workspace& workspace, const Json& params) {
  Analysis& analysis = AnalysisOf(workspace, params);
  return Completion(analysis, OffsetOf(analysis, params),
                    workspace.client.has_snippets);
}

Json ServeRename(Workspace& workspace, const Json& params) {
  Analysis& analysis = AnalysisOf(workspace, params);
  return Rename(analysis, OffsetOf(analysis, params),
                ReadString(params, "newName"));
}

Json ServeFormatting(Workspace& workspace, const Json& params) {
  return FormattingEdits(AnalysisOf(workspace, params));
}

Json ServeFormattingOfRange(Workspace& workspace, const Json& params) {
  const PlaceRange range = ReadRange(params, "range");
  return FormattingEdits(AnalysisOf(workspace, params), range.start.line,
                         range.end.line);
}

Json ServeFolding(Workspace& workspace, const Json& params) {
  return FoldingRanges(AnalysisOf(workspace, params));
}

Json ServeCodeActions(Workspace& workspace, const Json& params) {
  Document& document = workspace.documents.At(params);
  // Before it is whole it has what comments silence.
  const Advice& advice = document.advice;
  return CodeActions(*document.analysis,
                     advice.is_whole ? advice.found : std::vector<Diagnostic>(),
                     params);
}

Json ServeOutline(Workspace& workspace, const Json& params) {
  return Outline(AnalysisOf(workspace, params),
                 workspace.client.has_nested_symbols);
}

Json ServeTokens(Workspace& workspace, const Json& params) {
  Analysis& analysis = AnalysisOf(workspace, params);
  return SemanticTokens(analysis, WholeOf(analysis));
}

Json ServeTokensOfRange(Workspace& workspace, const Json& params) {
  Analysis& analysis = AnalysisOf(workspace, params);
  return SemanticTokens(analysis, SpanOf(analysis, params));
}

Json ServeHints(Workspace& workspace, const Json& params) {
  Analysis& analysis = AnalysisOf(workspace, params);
  return InlayHints(analysis, SpanOf(analysis, params),
                    workspace.settings.environment);
}

struct Request {
  std::string_view method;
  Serve serve;
};

constexpr std::array<Request, 17> kRequests = {{
    {"textDocument/codeAction", ServeCodeActions},
    {"textDocument/completion", ServeCompletion},
    {"textDocument/definition", AtPlace<Definition>},
    {"textDocument/documentHighlight", AtPlace<Highlights>},
    {"textDocument/documentSymbol", ServeOutline},
    {"textDocument/foldingRange", ServeFolding},
    {"textDocument/formatting", ServeFormatting},
    {"textDocument/hover", AtPlace<Hover>},
    {"textDocument/inlayHint", ServeHints},
    {"textDocument/prepareRename", AtPlace<PrepareRename>},
    {"textDocument/rangeFormatting", ServeFormattingOfRange},
    {"textDocument/references", ServeReferences},
    {"textDocument/rename", ServeRename},
    {"textDocument/semanticTokens/full", ServeTokens},
    {"textDocument/semanticTokens/range", ServeTokensOfRange},
    {"textDocument/signatureHelp", AtPlace<SignatureHelp>},
    {"workspace/executeCommand", ExecuteCommand},
}};

}  // namespace

Serve FindRequest(std::string_view method) {
  const auto found = std::find_if(
      kRequests.begin(), kRequests.end(),
      [&](const Request& request) { return request.method == method; });
  return found == kRequests.end() ? nullptr : found->serve;
}

}  // namespace plsc::lsp
