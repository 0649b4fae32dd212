#include "runtime/cli/files/png.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/runtime/cli/png_size.h"

namespace plsc {
namespace {

constexpr const char* kPicture =
    R"(<svg xmlns="http://www.w3.org/2000/svg" width="30" height="20" )"
    R"(viewBox="0 0 30 20"><rect width="30" height="20" fill="#fff"/>)"
    R"(<rect width="10" height="10" fill="#d7263d"/></svg>)";

TEST_CASE("a PNG has the size of the SVG times the scale", "[png]") {
  struct Row {
    double scale;
    unsigned width;
    unsigned height;
  };
  for (const Row& row : {Row{1, 30, 20}, Row{2.5, 75, 50}, Row{0.05, 2, 1}}) {
    INFO(row.scale);
    const auto png = cli::PngOf(kPicture, row.scale);
    INFO((png ? "" : png.error().text));
    REQUIRE(png);
    const auto size = test::PngSizeOf(*png);
    REQUIRE(size);
    CHECK(size->width == row.width);
    CHECK(size->height == row.height);
  }
}

TEST_CASE("a PNG shows what is in the SVG", "[png]") {
  const auto one = cli::PngOf(kPicture, 4);
  REQUIRE(one);
  std::string blank = kPicture;
  blank.replace(blank.find("#d7263d"), 7, "#ffffff");
  const auto other = cli::PngOf(blank, 4);
  REQUIRE(other);
  CHECK(*one != *other);
}

TEST_CASE("a PNG that cannot be made says why", "[png]") {
  struct Row {
    const char* why;
    const char* svg;
    double scale;
    const char* failure;
  };
  const std::vector<Row> rows = {
      {"no SVG", "no SVG", 1, "cannot read the picture"},
      {"too large", kPicture, 1e4, "PNG of 300000 x 200000 pixels"},
      {"no number", kPicture, std::nan(""), "PNG of nan x nan pixels"},
      {"too small", kPicture, 0.001, "PNG of 0 x 0 pixels"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const auto png = cli::PngOf(row.svg, row.scale);
      REQUIRE_FALSE(png);
      CHECK(png.error().text.find(row.failure) != std::string::npos);
    }
  }
}

TEST_CASE("a missing library is named with its package", "[png]") {
  cli::PngLibraries libraries;
  libraries.rsvg = "libnone.so.7";
  const auto png = cli::PngOf(kPicture, 1, libraries);
  REQUIRE_FALSE(png);
  CHECK(png.error().text.find("libnone.so.7 is missing") != std::string::npos);
  CHECK(png.error().text.find("apt-get install librsvg2-2") !=
        std::string::npos);
  // There, but another library.
  libraries.rsvg = "libc.so.6";
  CHECK(cli::PngOf(kPicture, 1, libraries).error().text.find("2.52") !=
        std::string::npos);
}

}  // namespace
}  // namespace plsc
