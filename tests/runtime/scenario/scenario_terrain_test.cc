#include "runtime/scenario/scenario_terrain.h"

#include <catch2/catch.hpp>

#include "runtime/scenario/scenario.h"
#include "runtime/scenario/scenario_yaml.h"
#include "tests/sim/terrains.h"

namespace plsc {

namespace {

/// Of a scenario of one season with that ground.
std::string TerrainErrors(const std::string& terrain) {
  const Source source("test.yaml", "seasons: [{terrain: " + terrain + "}]\n");
  const auto scenario = ParseScenario(source);
  return scenario ? "" : Render(scenario.diagnostics(), source, 0);
}

}  // namespace

TEST_CASE("A printed ground reads back equal", "[terrain]") {
  for (const Terrain& terrain : test::AllTerrains()) {
    const std::string text = PrintTerrain(terrain);
    INFO(text);
    const auto read =
        ParseScenario(Source("s", "seasons: [{terrain: " + text + "}]\n"));
    REQUIRE(read);
    CHECK(read->seasons[0].terrain == terrain);
    CHECK(read->seasons[0].name == NameIn(kTerrainNames, terrain.type));
  }
}

TEST_CASE("Parameters of a ground have units and defaults", "[terrain]") {
  const auto read = ParseScenario(
      Source("s",
             "seasons:\n"
             "  - terrain: {rough: {seed: 3, amplitude: 15 mm}}\n"
             "  - terrain: {steps: {height: 2 cm, depth: 40 cm, count: 5}}\n"
             "  - terrain: {obstacles: {size: 5 cm}}\n"
             "  - {name: bare, terrain: rough}\n"));
  REQUIRE(read);
  CHECK(read->seasons[0].terrain == test::RoughGround(3, 0.015, 0.2));
  CHECK(read->seasons[1].terrain == test::Stairs(0.02, 0.4, 5));
  CHECK(read->seasons[2].terrain == test::ObstacleField(1, 0.3, 0.05, 0.01));
  CHECK(read->seasons[3].terrain == test::RoughGround(1, 0.01, 0.2));
}

TEST_CASE("Mistakes in a ground are shown", "[terrain]") {
  struct Row {
    const char* why;
    const char* terrain;
    const char* part;
  };
  const std::vector<Row> rows = {
      {"no kind", "{}", "expected one kind of ground, found 0"},
      {"two kinds", "{tilted: 5 deg, rough: {}}",
       "expected one kind of ground, found 2"},
      {"obstacles in each other", "{obstacles: {size: 40 cm, spacing: 30 cm}}",
       "obstacles of 0.4 m do not fit squares of 0.3 m"},
      {"a length in degrees", "{rough: {amplitude: 5 deg}}",
       "expected a length in m, cm, mm or um, found 'deg'"},
      {"steps of no height", "{steps: {height: 0 m}}", "more than 0 m"},
      {"hills finer than any part", "{rough: {wavelength: 1 mm}}",
       "at least 0.02 m"},
      {"a key of another kind", "{steps: {seed: 1}}", "unknown key 'seed'"},
      {"not a map", "{rough: 5}", "its parameters"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const std::string errors = TerrainErrors(row.terrain);
      INFO(errors);
      CHECK(errors.find(row.part) != std::string::npos);
    }
  }
}

}  // namespace plsc
