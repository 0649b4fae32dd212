#include "runtime/lsp/signature_help.h"

#include <optional>
#include <string>
#include <string_view>

#include "grammar/keywords.h"
#include "runtime/lsp/descriptions.h"
#include "runtime/lsp/params.h"
#include "runtime/lsp/tokens.h"

namespace plsc::lsp {

namespace {

// The parentheses that a place is in.
struct Call {
  std::string_view symbol;
  std::size_t argument = 0;
};

std::optional<Call> CallAt(std::string_view text, std::uint32_t offset) {
  std::optional<Call> call;
  std::string_view item;
  std::string_view last;
  for (const Token& token : Tokenize(text)) {
    if (token.span.begin >= offset) break;
    if (token.kind == TokenKind::kComment) {
      if (token.span.end >= offset) return std::nullopt;
      continue;
    }
    const std::string_view word =
        text.substr(token.span.begin, token.span.end - token.span.begin);
    if (token.kind == TokenKind::kWord && IsItemKeyword(word)) {
      item = word;
      call.reset();
    } else if (word == "(") {
      call = Call{last};
    } else if (word == "," && call) {
      ++call->argument;
    } else if (word == ")" || word == "{" || word == "}") {
      call.reset();
    }
    last = word;
  }
  // An alphabet's own declarations have parameters, not arguments.
  if (item != "rule" && item != "test") return std::nullopt;
  return call;
}

}  // namespace

Json SignatureHelp(Analysis& analysis, std::uint32_t offset) {
  const auto call = CallAt(analysis.text(), offset);
  if (!call) return nullptr;
  const Section& section = analysis.SectionAt(offset);
  const AlphabetPtr& alphabet = section.scope.header.alphabet;
  const auto id =
      alphabet == nullptr ? std::nullopt : alphabet->Find(call->symbol);
  if (!id) return nullptr;
  const SymbolInfo& symbol = (*alphabet)[*id];
  Json parameters = Json::array();
  for (const Parameter& parameter : symbol.parameters)
    parameters.push_back(
        {{"label", parameter.name},
         {"documentation", MarkdownJson(DescribeParameter(parameter))}});
  Json signature = {{"label", SignatureOf(symbol)}};
  if (!symbol.doc.empty()) signature["documentation"] = symbol.doc;
  signature["parameters"] = std::move(parameters);
  Json help = {{"activeSignature", 0}, {"activeParameter", call->argument}};
  help["signatures"].push_back(std::move(signature));
  return help;
}

}  // namespace plsc::lsp
