#include "grammar/utf8.h"

#include <algorithm>

namespace plsc {

std::size_t CharacterLength(std::string_view text, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < text.size() && GoesOn(text[end])) ++end;
  return end - begin;
}

Character DecodeCharacter(std::string_view text, std::size_t begin) {
  const auto lead = static_cast<unsigned char>(text[begin]);
  if (lead < 0x80) return {1, lead, true};
  const std::size_t bytes = (lead & 0xE0) == 0xC0   ? 2
                            : (lead & 0xF0) == 0xE0 ? 3
                            : (lead & 0xF8) == 0xF0 ? 4
                                                    : 0;
  if (bytes == 0 || begin + bytes > text.size()) return {};
  char32_t code = lead & (0x7Fu >> bytes);
  for (std::size_t i = begin + 1; i < begin + bytes; ++i) {
    if (!GoesOn(text[i])) return {};
    code = (code << 6) | (static_cast<unsigned char>(text[i]) & 0x3Fu);
  }
  return {bytes, code, true};
}

std::size_t CountCharacters(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return !GoesOn(c); }));
}

std::string Shortened(std::string_view text, std::size_t characters) {
  constexpr std::string_view kDots = "...";
  if (CountCharacters(text) <= characters) return std::string(text);
  const std::size_t kept =
      characters < kDots.size() ? 0 : characters - kDots.size();
  std::size_t count = 0;
  std::size_t end = 0;
  while (end < text.size() && (GoesOn(text[end]) || count++ < kept)) ++end;
  return std::string(text.substr(0, end)) + std::string(kDots);
}

}  // namespace plsc
