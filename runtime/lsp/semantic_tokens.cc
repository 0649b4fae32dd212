#include "runtime/lsp/semantic_tokens.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "grammar/keywords.h"
#include "runtime/lsp/tokens.h"

namespace plsc::lsp {

namespace {

// Indices into kTypes, bits of kModifiers.
enum class Type : unsigned {
  kComment,
  kKeyword,
  kNumber,
  kOperator,
  kNamespace,
  kClass,
  kVariable,
  kEnumMember,
  kType,
  kFunction,
  kParameter,
  kStruct,
  kEvent,
  kProperty,
};
constexpr std::array<const char*, 14> kTypes = {
    "comment",   "keyword",  "number",     "operator", "namespace",
    "class",     "variable", "enumMember", "type",     "function",
    "parameter", "struct",   "event",      "property"};
constexpr std::array<const char*, 3> kModifiers = {"declaration", "readonly",
                                                   "defaultLibrary"};
constexpr unsigned kDeclaration = 1;
constexpr unsigned kReadonly = 2;
constexpr unsigned kDefaultLibrary = 4;

struct Painted {
  Span span;
  Type type{};
  unsigned modifiers = 0;
};

Type TypeOf(const Mention& mention) {
  using enum NameKind;
  switch (mention.kind) {
    case kGenotype:
      return Type::kClass;
    case kAlphabet:
      return Type::kNamespace;
    case kState:
    case kConstant:
      return Type::kVariable;
    case kValue:
      return Type::kEnumMember;
    case kSymbol:
      // What grows, and what tells the turtles where to go.
      return mention.is_module ? Type::kType : Type::kFunction;
    case kParameter:
      return Type::kParameter;
    case kEnvironment:
      return Type::kStruct;
    case kTest:
      return Type::kEvent;
    case kFace:
      return Type::kProperty;
  }
  return Type::kVariable;
}

unsigned ModifiersOf(const Mention& mention) {
  unsigned modifiers = 0;
  if (mention.is_declaration()) modifiers |= kDeclaration;
  if (mention.kind == NameKind::kConstant) modifiers |= kReadonly;
  if (mention.is_built_in) modifiers |= kDefaultLibrary;
  return modifiers;
}

std::optional<Painted> Paint(const Token& token, std::string_view text) {
  switch (token.kind) {
    case TokenKind::kComment:
      return Painted{token.span, Type::kComment};
    case TokenKind::kNumber:
      return Painted{token.span, Type::kNumber};
    case TokenKind::kOperator:
      return Painted{token.span, Type::kOperator};
    case TokenKind::kWord:
      if (IsKeyword(
              text.substr(token.span.begin, token.span.end - token.span.begin)))
        return Painted{token.span, Type::kKeyword};
      return std::nullopt;
    case TokenKind::kMark:
    case TokenKind::kOther:
      return std::nullopt;
  }
  return std::nullopt;
}

// Tokens of `span` in order; mentions win over words.
std::vector<Painted> PaintAll(Analysis& analysis, Span span) {
  std::vector<Painted> painted;
  const std::vector<Mention>& mentions = analysis.mentions();
  auto mention = mentions.begin();
  for (const Token& token : Tokenize(analysis.text())) {
    if (token.span.end < span.begin || token.span.begin > span.end) continue;
    while (mention != mentions.end() && mention->span.begin < token.span.begin)
      ++mention;
    if (mention != mentions.end() && mention->span == token.span)
      painted.push_back({token.span, TypeOf(*mention), ModifiersOf(*mention)});
    else if (auto one = Paint(token, analysis.text()))
      painted.push_back(*one);
  }
  return painted;
}

template <std::size_t N>
Json Names(const std::array<const char*, N>& names) {
  Json list = Json::array();
  for (const char* name : names) list.push_back(name);
  return list;
}

}  // namespace

Json SemanticTokensLegend() {
  return {{"tokenTypes", Names(kTypes)}, {"tokenModifiers", Names(kModifiers)}};
}

Json SemanticTokens(Analysis& analysis, Span span) {
  std::vector<std::uint32_t> data;
  Place last;
  for (const Painted& one : PaintAll(analysis, span)) {
    const Place place = analysis.lines().PlaceAt(one.span.begin);
    const bool is_same_line = place.line == last.line;
    data.push_back(place.line - last.line);
    data.push_back(is_same_line ? place.character - last.character
                                : place.character);
    data.push_back(Utf16Length(
        analysis.text().substr(one.span.begin, one.span.end - one.span.begin)));
    data.push_back(static_cast<std::uint32_t>(one.type));
    data.push_back(one.modifiers);
    last = place;
  }
  Json tokens = Json::object();
  tokens["data"] = std::move(data);
  return tokens;
}

}  // namespace plsc::lsp
