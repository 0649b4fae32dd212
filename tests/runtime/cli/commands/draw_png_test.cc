// `plsc draw` to a PNG, where plsc was built with librsvg.

#include <catch2/catch.hpp>

#include "tests/runtime/cli/png_size.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using test::kPlasticText;
using test::ReadFile;
using test::RunPlsc;

TEST_CASE("draw writes PNGs at a scale", "[draw]") {
  const test::TemporaryFolder folder;
  const std::string path = folder / "robot.png";
  for (const char* what : {"--colour=type", "--colour=rule", "--brain"}) {
    INFO(what);
    REQUIRE(
        RunPlsc({"draw", "-", "-o", path, what, "--scale", "1"}, kPlasticText)
            .exit == 0);
    const auto small = test::PngSizeOf(ReadFile(path));
    REQUIRE(RunPlsc({"draw", "-", "-o", path, what}, kPlasticText).exit == 0);
    const auto large = test::PngSizeOf(ReadFile(path));
    REQUIRE(small);
    REQUIRE(large);
    CHECK(small->width > 100);
    CHECK(large->width == 2 * small->width);
    CHECK(large->height == 2 * small->height);
    // All white, it would be a tenth of that.
    CHECK(ReadFile(path).size() > 5000);
  }
}

}  // namespace
}  // namespace plsc
