#pragma once

// Characters of UTF-8, where text must be counted or cut in them and not in
// bytes. What is given must be UTF-8.

#include <cstddef>
#include <string>
#include <string_view>

namespace plsc {

/// Whether the byte goes on with a character that began before it.
bool GoesOn(char byte);

/// Characters of UTF-8, each about as wide as another.
std::size_t LettersOf(std::string_view text);
/// At most so many characters, the last three of a longer text are "...".
std::string Shortened(std::string_view text, std::size_t letters);

}  // namespace plsc
