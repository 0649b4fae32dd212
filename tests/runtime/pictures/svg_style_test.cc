#include "runtime/pictures/svg_style.h"

#include <catch2/catch.hpp>
#include <set>
#include <string_view>

namespace plsc {
namespace {

TEST_CASE("every module has a colour of its own", "[svg_style]") {
  for (int a = 0; a <= static_cast<int>(ModuleType::kTouchSensor); ++a)
    for (int b = 0; b < a; ++b)
      CHECK(ModuleColour(static_cast<ModuleType>(a)) !=
            ModuleColour(static_cast<ModuleType>(b)));
}

TEST_CASE("eight numbers have colours of their own", "[svg_style]") {
  std::set<std::string_view> fills;
  for (std::size_t i = 0; i < 8; ++i) fills.insert(NumberColour(i).fill);
  CHECK(fills.size() == 8);
  CHECK(NumberColour(8).fill == NumberColour(0).fill);
}

}  // namespace
}  // namespace plsc
