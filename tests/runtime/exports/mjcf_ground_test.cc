#include "runtime/exports/mjcf_ground.h"

#include <catch2/catch.hpp>

#include "runtime/text/xml.h"
#include "tests/sim/bodies.h"

namespace plsc {
namespace {

// MuJoCo reads them in mjcf_world_test.cc, where it is installed.

MjcfGround GroundUnder(const Terrain& terrain) {
  return GroundInMjcf(
      ModelOf({"cross", "x"}, {Cross(), {}}, ExportedOptions(), terrain));
}

std::string TextOf(const std::vector<XmlElement>& elements) {
  std::string text;
  for (const XmlElement& one : elements) text += PrintXml(one);
  return text;
}

TEST_CASE("A flat ground is a light and a plane", "[mjcf_ground]") {
  const MjcfGround ground = GroundUnder({});
  CHECK_FALSE(ground.asset);
  REQUIRE(ground.geoms.size() == 2);
  CHECK(ground.geoms[0].name == "light");
  const std::string plane = PrintXml(ground.geoms[1]);
  CHECK(plane.find("type=\"plane\"") != std::string::npos);
  CHECK(plane.find("quat") == std::string::npos);
}

TEST_CASE("Rough ground without hills is a plane", "[mjcf_ground]") {
  Terrain rough;
  rough.type = TerrainType::kRough;
  rough.rough.amplitude = 0;
  CHECK_FALSE(GroundUnder(rough).asset);
  rough.rough.amplitude = 0.01;
  const MjcfGround hills = GroundUnder(rough);
  REQUIRE(hills.asset);
  const std::string text = PrintXml(*hills.asset);
  CHECK(text.find("nrow=\"401\" ncol=\"401\"") != std::string::npos);
  CHECK(TextOf(hills.geoms).find("hfield=\"rough\"") != std::string::npos);
}

}  // namespace
}  // namespace plsc
