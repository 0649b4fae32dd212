#include "runtime/text/utf8.h"

#include <algorithm>

namespace plsc {

bool GoesOn(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

std::size_t LettersOf(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return !GoesOn(c); }));
}

std::string Shortened(std::string_view text, std::size_t letters) {
  constexpr std::string_view kDots = "...";
  if (LettersOf(text) <= letters) return std::string(text);
  const std::size_t kept = letters < kDots.size() ? 0 : letters - kDots.size();
  std::size_t count = 0;
  std::size_t end = 0;
  while (end < text.size() && (GoesOn(text[end]) || count++ < kept)) ++end;
  return std::string(text.substr(0, end)) + std::string(kDots);
}

}  // namespace plsc
