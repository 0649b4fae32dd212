#include "runtime/recording/ground_json.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "runtime/recording/track.h"
#include "sim/height_field.h"

namespace plsc {
namespace {

/// A robot of one link that goes from `from` to `to`.
RecordedSeason Moving(TerrainType type, const Eigen::Vector2d& from,
                      const Eigen::Vector2d& to) {
  RecordedSeason season;
  season.terrain.type = type;
  season.motion.steps = {0, 4};
  season.motion.position.resize(3, 2);
  season.motion.position.col(0) << from, 0.02;
  season.motion.position.col(1) << to, 0.02;
  return season;
}

Eigen::MatrixXd Numbers(const nlohmann::json& track, const char* columns) {
  const auto numbers =
      DecodeTrack(track["data"].get<std::string>(), track["rows"].get<int>(),
                  track[columns].get<int>(), track["unit"]);
  REQUIRE(numbers);
  return *numbers;
}

TEST_CASE("ground is told as far as a robot came, and a margin",
          "[ground_json]") {
  const auto extent =
      GroundExtent(Moving(TerrainType::kFlat, {0, 0}, {0.5, -2}));
  CHECK(extent.min().x() == Approx(-kGroundMargin));
  CHECK(extent.max().x() == Approx(0.5 + kGroundMargin));
  CHECK(extent.min().y() == Approx(-2 - kGroundMargin));
  CHECK(extent.max().y() == Approx(kGroundMargin));

  SECTION("not around the world for one who was thrown there") {
    const auto far = GroundExtent(Moving(TerrainType::kFlat, {1, 0}, {1e8, 0}));
    CHECK(far.max().x() == Approx(1 + kFarthestGround + kGroundMargin));
  }
  SECTION("around the origin for one who did not live") {
    CHECK(GroundExtent(RecordedSeason()).max().x() == Approx(kGroundMargin));
  }
}

TEST_CASE("planes have no relief", "[ground_json]") {
  for (const TerrainType type : {TerrainType::kFlat, TerrainType::kTilted})
    CHECK(GroundJson(Moving(type, {0, 0}, {1, 1})) == "{}");
}

TEST_CASE("rough ground is told by its heights", "[ground_json]") {
  const RecordedSeason season =
      Moving(TerrainType::kRough, {0, 0}, {0.5, -0.3});
  const nlohmann::json heights =
      nlohmann::json::parse(GroundJson(season))["heights"];
  const Eigen::MatrixXd numbers = Numbers(heights, "columns");
  const HeightField field(season.terrain.rough);
  const double spacing = heights["spacing"];
  CHECK(spacing <= season.terrain.rough.wavelength / 4);
  CHECK(numbers.size() <= kMaxHeights);
  // Those of the simulator, over all of the extent.
  const int row = 7;
  const int column = 11;
  const double x = heights["x"].get<double>() + spacing * column;
  const double y = heights["y"].get<double>() + spacing * row;
  CHECK(numbers(row, column) == Approx(field.At(x, y).height).margin(1e-4));
  CHECK(heights["x"].get<double>() +
            spacing * static_cast<double>(numbers.cols() - 1) >=
        0.5 + kGroundMargin);

  SECTION("coarser where it would be too much") {
    RecordedSeason far = Moving(TerrainType::kRough, {0, 0}, {15, 12});
    far.terrain.rough.wavelength = 0.02;
    const nlohmann::json coarse =
        nlohmann::json::parse(GroundJson(far))["heights"];
    CHECK(coarse["rows"].get<int>() * coarse["columns"].get<int>() <=
          kMaxHeights);
    CHECK(GroundJson(far).size() < 120000);
  }
}

TEST_CASE("steps and obstacles are told as boxes", "[ground_json]") {
  RecordedSeason season = Moving(TerrainType::kSteps, {0, 0}, {0, 0.2});
  season.terrain.steps = {0.01, 0.5, 20};
  const Eigen::MatrixXd steps =
      Numbers(nlohmann::json::parse(GroundJson(season))["boxes"], "samples");
  REQUIRE(steps.rows() == 5);
  REQUIRE(steps.cols() == 3);  // at 0.5, 1 and 1.5 m, up to 1.7 m
  CHECK(steps(4, 0) == Approx(0.01));
  CHECK(steps(4, 2) == Approx(0.03));
  CHECK(steps(1, 0) - steps(3, 0) / 2 == Approx(0.5));
  CHECK(steps(1, 0) + steps(3, 0) / 2 == Approx(0.2 + kGroundMargin));
  CHECK(steps(2, 0) == Approx(2 * kGroundMargin));

  season.terrain.type = TerrainType::kObstacles;
  const Eigen::MatrixXd obstacles =
      Numbers(nlohmann::json::parse(GroundJson(season))["boxes"], "samples");
  CHECK(obstacles.cols() > 50);  // 3 m to 3.2 m of squares of 0.3 m
  CHECK(obstacles.row(2).maxCoeff() <= season.terrain.obstacles.size + 1e-4);
  CHECK(obstacles.row(4).maxCoeff() <= season.terrain.obstacles.height + 1e-4);

  SECTION("as many as a page can show") {
    season.terrain.obstacles.spacing = 0.004;
    season.terrain.obstacles.size = 0.003;
    const Eigen::MatrixXd many =
        Numbers(nlohmann::json::parse(GroundJson(season))["boxes"], "samples");
    CHECK(many.cols() <= kMaxBoxes);
    CHECK(many.cols() > kMaxBoxes / 4);  // none stands near the origin
  }
}

}  // namespace
}  // namespace plsc
