// Where plsc was built without librsvg's headers.

#include <catch2/catch.hpp>
#include <filesystem>

#include "runtime/cli/files/png.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

TEST_CASE("without librsvg there are no PNGs, and a reason", "[png]") {
  CHECK(cli::PngOf("<svg/>", 1).failure().find("built without librsvg") !=
        std::string::npos);
  const test::TemporaryFolder folder;
  const std::string path = folder / "robot.png";
  const auto ran = test::RunPlsc({"draw", "-", "-o", path}, test::kPlasticText);
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("write an .svg") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace plsc
