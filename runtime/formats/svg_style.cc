#include "runtime/formats/svg_style.h"

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

}  // namespace plsc
