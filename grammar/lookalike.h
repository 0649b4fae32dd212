#pragma once

// Characters that are taken for another, or for none: what editors, word
// processors and pages make of '-', '"' or a blank, letters of other alphabets
// that look like Latin ones, and what cannot be seen. Outside of comments only
// ASCII has a meaning, so each of them is an error that eyes do not find.

#include <optional>
#include <string>
#include <string_view>

namespace plsc {

struct Lookalike {
  std::size_t bytes = 0;  ///< of the character in UTF-8
  std::string code;       ///< "U+2212"
  std::string_view name;  ///< "a minus sign"
  std::string intended;   ///< what to write instead; may be empty
};

/// The one that begins the text; nothing when none does.
std::optional<Lookalike> LookalikeAt(std::string_view text);

/// "U+00E9" of the character that begins the text, which is UTF-8.
std::string CodePointText(std::string_view text);

}  // namespace plsc
