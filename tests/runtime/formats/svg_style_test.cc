#include "runtime/formats/svg_style.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("text is safe in XML", "[svg_style]") {
  CHECK(EscapeXml("a<b> & \"c\" \x01\n\u00e9") ==
        "a&lt;b&gt; &amp; &quot;c&quot; \u00e9");
}

TEST_CASE("every module has a colour of its own", "[svg_style]") {
  for (int a = 0; a <= static_cast<int>(ModuleType::kTouchSensor); ++a)
    for (int b = 0; b < a; ++b)
      CHECK(ModuleColour(static_cast<ModuleType>(a)) !=
            ModuleColour(static_cast<ModuleType>(b)));
}

}  // namespace
}  // namespace plsc
