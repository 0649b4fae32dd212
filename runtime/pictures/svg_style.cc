#include "runtime/pictures/svg_style.h"

#include <algorithm>
#include <array>

namespace plsc {

std::string_view ModuleColour(ModuleType type) {
  switch (type) {
    case ModuleType::kCore:
      return "#ffe135";
    case ModuleType::kBrick:
      return "#5b8ff9";
    case ModuleType::kVerticalJoint:
      return "#d7263d";
    case ModuleType::kHorizontalJoint:
      return "#ff9f9f";
    case ModuleType::kTouchSensor:
      return "#2ca02c";
  }
  return "#000000";
}

std::string EscapeXml(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else if (static_cast<unsigned char>(c) >= ' ')
      escaped += c;
  }
  return escaped;
}

namespace {

// Whether a byte goes on with a character of UTF-8.
bool GoesOn(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

}  // namespace

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

InkOn NumberColour(std::size_t number) {
  // Okabe and Ito 2008, "Color Universal Design"; the lighter ones first. White
  // on blue, as black there has a contrast of 4 only.
  constexpr std::array<InkOn, 8> kColours{{{"#e69f00", "#000"},
                                           {"#56b4e9", "#000"},
                                           {"#f0e442", "#000"},
                                           {"#cc79a7", "#000"},
                                           {"#009e73", "#000"},
                                           {"#d55e00", "#000"},
                                           {"#0072b2", "#fff"},
                                           {"#bbbbbb", "#000"}}};
  return kColours[number % kColours.size()];
}

}  // namespace plsc
