#include "grammar/shown_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace plsc {

namespace {

constexpr std::size_t kTabWidth = 4;  // columns

struct Character {
  std::size_t bytes = 1;
  char32_t code = 0;
  bool is_valid = false;
};

// The UTF-8 character that begins at `i`; one invalid byte where none does.
Character Decode(std::string_view line, std::size_t i) {
  const auto lead = static_cast<unsigned char>(line[i]);
  if (lead < 0x80) return {1, lead, true};
  const std::size_t bytes = (lead & 0xE0) == 0xC0   ? 2
                            : (lead & 0xF0) == 0xE0 ? 3
                            : (lead & 0xF8) == 0xF0 ? 4
                                                    : 0;
  if (bytes == 0 || i + bytes > line.size()) return {};
  char32_t code = lead & (0x7Fu >> bytes);
  for (std::size_t k = 1; k < bytes; ++k) {
    const auto next = static_cast<unsigned char>(line[i + k]);
    if ((next & 0xC0) != 0x80) return {};
    code = (code << 6) | (next & 0x3Fu);
  }
  return {bytes, code, true};
}

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
    const Character character = Decode(line, i);
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
    const Character character = Decode(text, i);
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
