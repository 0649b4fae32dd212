// A scanner beside the parser, because colours and completions are wanted while
// a text does not parse. It reads any bytes, ends always (each piece has a byte
// at least), and agrees with rules.h about what a word, a number and an
// operator is; where the two differ an editor shows a wrong colour and nothing
// worse.

#include "runtime/lsp/tokens.h"

#include <algorithm>
#include <array>

#include "grammar/keywords.h"
#include "grammar/utf8.h"

namespace plsc::lsp {

namespace {

bool IsDigit(char c) {
  return c >= '0' && c <= '9';
}

bool IsBlank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

bool IsMark(char c) {
  return c == '{' || c == '}' || c == '(' || c == ')' || c == ',' || c == ';' ||
         c == ':';
}

constexpr std::array<std::string_view, 7> kOperators = {
    "->", "!=", "<=", ">=", "=", "<", ">"};

// `rest` begins with a digit, or '-' and a digit.
std::size_t NumberLength(std::string_view rest) {
  const auto digits = [&](std::size_t at) {
    while (at < rest.size() && IsDigit(rest[at])) ++at;
    return at;
  };
  const auto is_digit = [&](std::size_t at) {
    return at < rest.size() && IsDigit(rest[at]);
  };
  std::size_t at = digits(1);
  // Of `1..5` the points are a mark.
  if (at < rest.size() && rest[at] == '.' && is_digit(at + 1))
    at = digits(at + 1);
  if (at < rest.size() && (rest[at] == 'e' || rest[at] == 'E')) {
    std::size_t exponent = at + 1;
    if (exponent < rest.size() &&
        (rest[exponent] == '+' || rest[exponent] == '-'))
      ++exponent;
    if (is_digit(exponent)) at = digits(exponent);
  }
  return at;
}

struct Piece {
  TokenKind kind = TokenKind::kOther;
  std::size_t length = 1;
};

// What `rest`, which begins with no blank, begins with.
Piece FirstPiece(std::string_view rest) {
  const char c = rest[0];
  if (c == '#')
    return {TokenKind::kComment,
            std::min(rest.find_first_of("\r\n"), rest.size())};
  if (IsDigit(c) || (c == '-' && rest.size() > 1 && IsDigit(rest[1])))
    return {TokenKind::kNumber, NumberLength(rest)};
  if (IsWordCharacter(c)) {
    std::size_t length = 1;
    while (length < rest.size() && IsWordCharacter(rest[length])) ++length;
    return {TokenKind::kWord, length};
  }
  for (const std::string_view name : kOperators)
    if (rest.starts_with(name)) return {TokenKind::kOperator, name.size()};
  if (rest.starts_with("..")) return {TokenKind::kMark, 2};
  if (IsMark(c)) return {TokenKind::kMark, 1};
  return {TokenKind::kOther, CharacterLength(rest, 0)};
}

}  // namespace

std::vector<Token> Tokenize(std::string_view text) {
  std::vector<Token> tokens;
  std::size_t at = TextBegin(text);
  while (at < text.size()) {
    if (IsBlank(text[at])) {
      ++at;
      continue;
    }
    const Piece piece = FirstPiece(text.substr(at));
    tokens.push_back({{static_cast<std::uint32_t>(at),
                       static_cast<std::uint32_t>(at + piece.length)},
                      piece.kind});
    at += piece.length;
  }
  return tokens;
}

}  // namespace plsc::lsp
