#pragma once

// Characters of UTF-8, where text must be counted, read or cut in them and not
// in bytes. What is no UTF-8 is one character a byte.

#include <cstddef>
#include <string>
#include <string_view>

namespace plsc {

/// Whether the byte goes on with a character that began before it.
inline bool GoesOn(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// Bytes of the character that begins at `begin`.
std::size_t CharacterLength(std::string_view text, std::size_t begin);

struct Character {
  std::size_t bytes = 1;
  char32_t code = 0;
  bool is_valid = false;
};
/// The character that begins at `begin`; one invalid byte where none does.
Character DecodeCharacter(std::string_view text, std::size_t begin);

std::size_t CountCharacters(std::string_view text);
/// At most so many characters, the last three of a longer text are "...".
std::string Shortened(std::string_view text, std::size_t characters);

}  // namespace plsc
