#include "runtime/pictures/svg_style.h"

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
