#pragma once

// The words of a text without its grammar: what colours and completion go by,
// because both are wanted while the text is broken. Reads any bytes.

#include <string_view>
#include <vector>

#include "grammar/source.h"

namespace plsc::lsp {

enum class TokenKind : std::uint8_t {
  kWord,      ///< a name or a keyword
  kNumber,    ///< -1.5e3
  kOperator,  ///< -> = != <= >= < >
  kMark,      ///< { } ( ) , ; : ..
  kComment,   ///< from # to before the line's end
  kOther,     ///< what the language does not have
};

struct Token {
  Span span;
  TokenKind kind = TokenKind::kOther;
};

/// In order; blanks and a byte order mark are left out.
std::vector<Token> Tokenize(std::string_view text);

}  // namespace plsc::lsp
