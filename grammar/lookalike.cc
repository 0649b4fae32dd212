#include "grammar/lookalike.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "grammar/utf8.h"

namespace plsc {

namespace {

struct Row {
  char32_t first;
  char32_t last;
  std::string_view name;
  std::string_view intended;
};

// Sorted; Unicode 15.
constexpr Row kRows[] = {
    {0x00A0, 0x00A0, "a no-break space", " "},
    {0x00AD, 0x00AD, "a soft hyphen", ""},
    {0x037E, 0x037E, "a Greek question mark", ";"},
    {0x0391, 0x0391, "a Greek letter", "A"},
    {0x0392, 0x0392, "a Greek letter", "B"},
    {0x0395, 0x0395, "a Greek letter", "E"},
    {0x0396, 0x0396, "a Greek letter", "Z"},
    {0x0397, 0x0397, "a Greek letter", "H"},
    {0x0399, 0x0399, "a Greek letter", "I"},
    {0x039A, 0x039A, "a Greek letter", "K"},
    {0x039C, 0x039C, "a Greek letter", "M"},
    {0x039D, 0x039D, "a Greek letter", "N"},
    {0x039F, 0x039F, "a Greek letter", "O"},
    {0x03A1, 0x03A1, "a Greek letter", "P"},
    {0x03A4, 0x03A4, "a Greek letter", "T"},
    {0x03A5, 0x03A5, "a Greek letter", "Y"},
    {0x03A7, 0x03A7, "a Greek letter", "X"},
    {0x03BF, 0x03BF, "a Greek letter", "o"},
    {0x0405, 0x0405, "a Cyrillic letter", "S"},
    {0x0406, 0x0406, "a Cyrillic letter", "I"},
    {0x0408, 0x0408, "a Cyrillic letter", "J"},
    {0x0410, 0x0410, "a Cyrillic letter", "A"},
    {0x0412, 0x0412, "a Cyrillic letter", "B"},
    {0x0415, 0x0415, "a Cyrillic letter", "E"},
    {0x041A, 0x041A, "a Cyrillic letter", "K"},
    {0x041C, 0x041C, "a Cyrillic letter", "M"},
    {0x041D, 0x041D, "a Cyrillic letter", "H"},
    {0x041E, 0x041E, "a Cyrillic letter", "O"},
    {0x0420, 0x0420, "a Cyrillic letter", "P"},
    {0x0421, 0x0421, "a Cyrillic letter", "C"},
    {0x0422, 0x0422, "a Cyrillic letter", "T"},
    {0x0423, 0x0423, "a Cyrillic letter", "Y"},
    {0x0425, 0x0425, "a Cyrillic letter", "X"},
    {0x0430, 0x0430, "a Cyrillic letter", "a"},
    {0x0435, 0x0435, "a Cyrillic letter", "e"},
    {0x043E, 0x043E, "a Cyrillic letter", "o"},
    {0x0440, 0x0440, "a Cyrillic letter", "p"},
    {0x0441, 0x0441, "a Cyrillic letter", "c"},
    {0x0443, 0x0443, "a Cyrillic letter", "y"},
    {0x0445, 0x0445, "a Cyrillic letter", "x"},
    {0x0455, 0x0455, "a Cyrillic letter", "s"},
    {0x0456, 0x0456, "a Cyrillic letter", "i"},
    {0x0458, 0x0458, "a Cyrillic letter", "j"},
    {0x1680, 0x1680, "a space of another width", " "},
    {0x180E, 0x180E, "an invisible separator", ""},
    {0x2000, 0x200A, "a space of another width", " "},
    {0x200B, 0x200B, "a zero width space", ""},
    {0x200C, 0x200D, "a zero width joiner", ""},
    {0x200E, 0x200F, "an invisible mark of direction", ""},
    {0x2010, 0x2015, "a hyphen or dash", "-"},
    {0x2018, 0x201F, "a curly quote", ""},
    {0x2026, 0x2026, "an ellipsis", ".."},
    {0x2028, 0x2029, "a separator of lines", "\n"},
    {0x202A, 0x202E, "an invisible mark of direction", ""},
    {0x202F, 0x202F, "a narrow no-break space", " "},
    {0x2032, 0x2033, "a prime", ""},
    {0x205F, 0x205F, "a space of another width", " "},
    {0x2060, 0x2060, "an invisible word joiner", ""},
    {0x2066, 0x2069, "an invisible mark of direction", ""},
    {0x2192, 0x2192, "an arrow", "->"},
    {0x2212, 0x2212, "a minus sign", "-"},
    {0x2227, 0x2227, "a sign of logic", "and"},
    {0x2228, 0x2228, "a sign of logic", "or"},
    {0x2260, 0x2260, "a sign of comparison", "!="},
    {0x2264, 0x2264, "a sign of comparison", "<="},
    {0x2265, 0x2265, "a sign of comparison", ">="},
    {0x3000, 0x3000, "an ideographic space", " "},
    {0xFE63, 0xFE63, "a small hyphen", "-"},
    {0xFEFF, 0xFEFF, "a byte order mark", ""},
    {0xFF01, 0xFF5E, "a fullwidth character", ""},  // each is its own
};

constexpr char32_t kFirstFullwidth = 0xFF01;
constexpr char32_t kLastFullwidth = 0xFF5E;

std::string CodePointName(char32_t code) {
  return fmt::format("U+{:04X}", static_cast<std::uint32_t>(code));
}

}  // namespace

std::optional<Lookalike> LookalikeAt(std::string_view text) {
  if (text.empty() || static_cast<unsigned char>(text[0]) < 0x80)
    return std::nullopt;
  const Character found = DecodeCharacter(text, 0);
  const Row* row = std::upper_bound(
      std::begin(kRows), std::end(kRows), found.code,
      [](char32_t code, const Row& one) { return code <= one.last; });
  if (row == std::end(kRows) || found.code < row->first) return std::nullopt;
  Lookalike lookalike{found.bytes, CodePointName(found.code), row->name,
                      std::string(row->intended)};
  if (found.code >= kFirstFullwidth && found.code <= kLastFullwidth)
    lookalike.intended = static_cast<char>(found.code - kFirstFullwidth + U'!');
  return lookalike;
}

std::string CodePointText(std::string_view text) {
  return CodePointName(DecodeCharacter(text, 0).code);
}

}  // namespace plsc
