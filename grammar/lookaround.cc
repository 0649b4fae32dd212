#include "grammar/lookaround.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "grammar/keywords.h"
#include "grammar/lookalike.h"
#include "grammar/utf8.h"

namespace plsc {

namespace {

constexpr std::string_view kOperatorCharacters = "=<>!&|:~^+*/-";
// Longest part of a token that a message repeats.
constexpr std::size_t kMaxQuoted = 40;

struct Foreign {
  std::string_view foreign;
  std::string_view plsc;
};

constexpr std::array<Foreign, 20> kForeign = {{
    {"==", "="},      {"===", "="},       {":=", "="},      {"is", "="},
    {"<>", "!="},     {"!==", "!="},      {"=<", "<="},     {"=>", ">="},
    {"&&", "and"},    {"&", "and"},       {"AND", "and"},   {"And", "and"},
    {"||", "or"},     {"|", "or"},        {"OR", "or"},     {"Or", "or"},
    {"true", "True"}, {"false", "False"}, {"TRUE", "True"}, {"FALSE", "False"},
}};

bool IsOperator(char c) {
  return kOperatorCharacters.find(c) != std::string_view::npos;
}

Found Make(std::string_view text, std::size_t begin, std::size_t end) {
  Found found;
  found.span = {static_cast<std::uint32_t>(begin),
                static_cast<std::uint32_t>(end)};
  found.text = text.substr(begin, end - begin);
  const unsigned char first = static_cast<unsigned char>(found.text[0]);
  if (first < ' ' || first == 0x7F)
    found.quoted = fmt::format("character 0x{:02X}", first);
  else if (found.text.size() > kMaxQuoted)
    found.quoted = fmt::format("'{}...'", found.text.substr(0, kMaxQuoted));
  else if (first >= 0x80)
    found.quoted =
        fmt::format("'{}' ({})", found.text, CodePointText(found.text));
  else
    found.quoted = fmt::format("'{}'", found.text);
  return found;
}

template <typename Predicate>
std::size_t EndOf(std::string_view text, std::size_t begin, Predicate is_part) {
  std::size_t end = begin;
  while (end < text.size() && is_part(text[end])) ++end;
  return end;
}

}  // namespace

Found FoundAt(std::string_view text, std::uint32_t offset) {
  if (offset >= text.size()) {
    const auto end = static_cast<std::uint32_t>(text.size());
    return {{end, end}, "", "the end of the file", true};
  }
  const char c = text[offset];
  if (IsWordCharacter(c)) {
    std::size_t begin = offset;
    while (begin > 0 && IsWordCharacter(text[begin - 1])) --begin;
    return Make(text, begin, EndOf(text, begin, IsWordCharacter));
  }
  if (IsOperator(c)) return Make(text, offset, EndOf(text, offset, IsOperator));
  return Make(text, offset, offset + CharacterLength(text, offset));
}

Found FoundBefore(std::string_view text, std::uint32_t end) {
  if (end == 0) return {{0, 0}, "", "the beginning of the file", false};
  std::size_t begin = end - 1;
  const auto extend = [&](auto is_part) {
    while (begin > 0 && is_part(text[begin - 1])) --begin;
  };
  if (IsWordCharacter(text[begin]))
    extend([](char c) { return IsWordCharacter(c) || c == '.' || c == '-'; });
  else if (IsOperator(text[begin]))
    extend(IsOperator);
  else if (text[begin] == '.')
    extend([](char c) { return c == '.'; });
  return Make(text, begin, end);
}

Span CaretOf(const SyntaxContext& context) {
  const std::string_view between = context.text.substr(
      context.previous_end,
      std::max(context.offset, context.previous_end) - context.previous_end);
  if (between.find('\n') != std::string_view::npos)
    return {context.previous_end, context.previous_end};
  return FoundAt(context.text, context.offset).span;
}

bool IsItemOrEnd(const Found& found) {
  return found.is_end || IsItemKeyword(found.text);
}

std::string_view PlscWordFor(std::string_view foreign) {
  for (const Foreign& row : kForeign)
    if (row.foreign == foreign) return row.plsc;
  return {};
}

}  // namespace plsc
