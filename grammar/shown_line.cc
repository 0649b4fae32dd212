// Every byte of a user's text may reach a terminal, and some would drive it
// (escape sequences, a carriage return that hides what stands before, marks
// that turn the direction of writing). So what is no printable character is
// shown by its number, and columns are counted as shown, by character: the mark
// of a message must stand below what it means.

#include "grammar/shown_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "grammar/utf8.h"

namespace plsc {

namespace {

constexpr std::size_t kTabWidth = 4;  // columns

bool IsPrintable(const Character& character) {
  const char32_t code = character.code;
  const bool is_control = code < 0x20 || (code >= 0x7F && code < 0xA0);
  // Marks that turn the direction of what follows (U+200E, U+202A, U+2066
  // and their kin) would show other text than the file has.
  const bool turns_direction =
      code == 0x200E || code == 0x200F || code == 0x061C ||
      (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
  // Carets would stand beside what they mean.
  const bool is_invisible = code == 0x00AD ||
                            (code >= 0x200B && code <= 0x200D) ||
                            code == 0x2060 || code == 0xFEFF || code == 0x180E;
  return character.is_valid && !is_control && !turns_direction && !is_invisible;
}

}  // namespace

std::string ShownLine::Text(std::size_t from, std::size_t count) const {
  std::string text;
  const std::size_t end = std::min(columns.size(), from + count);
  for (std::size_t i = from; i < end; ++i) text += columns[i];
  return text;
}

ShownLine ShownLineOf(std::string_view line) {
  ShownLine shown;
  for (std::size_t i = 0; i < line.size();) {
    const std::size_t column = shown.columns.size();
    const Character character = DecodeCharacter(line, i);
    if (line[i] == '\t')
      shown.columns.resize(column + kTabWidth - column % kTabWidth, " ");
    else if (IsPrintable(character))
      shown.columns.emplace_back(line.substr(i, character.bytes));
    else
      shown.columns.emplace_back("?");
    shown.column_of_byte.resize(shown.column_of_byte.size() + character.bytes,
                                column);
    i += character.bytes;
  }
  shown.column_of_byte.push_back(shown.columns.size());
  return shown;
}

std::string Escaped(std::string_view text) {
  std::string escaped;
  for (std::size_t i = 0; i < text.size();) {
    const Character character = DecodeCharacter(text, i);
    const auto byte = static_cast<unsigned char>(text[i]);
    if (IsPrintable(character))
      escaped += text.substr(i, character.bytes);
    else if (byte == '\n')
      escaped += "\\n";
    else if (byte == '\r')
      escaped += "\\r";
    else if (byte == '\t')
      escaped += "\\t";
    else if (!character.is_valid || byte < 0x80)
      escaped += fmt::format("\\x{:02x}", byte);
    else
      escaped += fmt::format("\\u{:04x}", std::uint32_t{character.code});
    i += character.bytes;
  }
  return escaped;
}

std::string Printable(std::string_view text, std::size_t limit) {
  // No character has more than four bytes, so more need not be looked at.
  const ShownLine shown = ShownLineOf(text.substr(0, 4 * (limit + 1)));
  std::string printable = shown.Text(0, limit);
  if (shown.columns.size() > limit) printable += "...";
  return printable;
}

}  // namespace plsc
