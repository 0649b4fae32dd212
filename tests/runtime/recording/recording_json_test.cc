#include "runtime/recording/recording_json.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/runtime/recording/recorded.h"

namespace plsc {
namespace {

Recording Reread(const std::string& text) {
  const Source source("r.json", text);
  Result<Recording> recording = ParseRecording(source);
  if (!recording) FAIL(Render(recording.diagnostics(), source));
  return *recording;
}

TEST_CASE("a recording comes back but for rounding", "[recording_json]") {
  const Recording written = test::SmallRecording();
  const std::string text = RecordingJson(written);
  const Recording read = Reread(text);
  CHECK(RecordingJson(read) == text);
  CHECK(read.name == written.name);
  CHECK(read.genotype == written.genotype);
  CHECK(read.scenario == written.scenario);
  REQUIRE(read.seasons.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    const RecordedSeason& a = written.seasons[i];
    const RecordedSeason& b = read.seasons[i];
    CHECK(a.terrain == b.terrain);
    CHECK(a.outcome == b.outcome);
    CHECK(a.speed == b.speed);
    CHECK(a.balance == b.balance);
    CHECK(a.targets == std::vector<Target>{{1, -2.5}});
    CHECK(a.targets == b.targets);
    CHECK(a.motion.steps == b.motion.steps);
    CHECK(a.motion.touch == b.motion.touch);
    CHECK((a.motion.position - b.motion.position).cwiseAbs().maxCoeff() <=
          0.51 * kPositionUnit);
    CHECK((a.motion.turn - b.motion.turn).cwiseAbs().maxCoeff() <=
          0.51 * kTurnUnit);
    CHECK((a.motion.joint_angle - b.motion.joint_angle).cwiseAbs().maxCoeff() <=
          0.51 * kAngleUnit);
    CHECK(a.body.links[1].boxes[0].centre == b.body.links[1].boxes[0].centre);
    CHECK(a.body.joints[0].anchor == b.body.joints[0].anchor);
  }
}

TEST_CASE("seasons without targets say nothing of them", "[recording_json]") {
  Recording recording = test::SmallRecording();
  CHECK(RecordingJson(recording).find("targets") != std::string::npos);
  for (RecordedSeason& season : recording.seasons) season.targets.clear();
  const std::string text = RecordingJson(recording);
  CHECK(text.find("targets") == std::string::npos);
  CHECK(Reread(text).seasons[0].targets.empty());
}

TEST_CASE("every terrain comes back", "[recording_json]") {
  for (const TerrainType type :
       {TerrainType::kFlat, TerrainType::kTilted, TerrainType::kRough,
        TerrainType::kSteps, TerrainType::kObstacles}) {
    Recording recording;
    recording.seasons.emplace_back();
    Terrain& terrain = recording.seasons[0].terrain;
    terrain.type = type;
    switch (type) {
      case TerrainType::kFlat:
        break;
      case TerrainType::kTilted:
        terrain.tilt = 0.1;
        break;
      case TerrainType::kRough:
        terrain.rough = {~std::uint64_t{0}, 0.02, 0.3};
        break;
      case TerrainType::kSteps:
        terrain.steps = {0.02, 0.4, 7};
        break;
      case TerrainType::kObstacles:
        terrain.obstacles = {~std::uint64_t{0} - 1, 0.4, 0.2, 0.03};
        break;
    }
    CHECK(Reread(RecordingJson(recording)).seasons[0].terrain == terrain);
  }
}

TEST_CASE("a season that was not simulated has no samples",
          "[recording_json]") {
  Recording recording;
  recording.seasons.emplace_back();
  RecordedSeason& season = recording.seasons[0];
  season.outcome = Outcome::kOverlapping;
  season.reason = "1 pair of \"parts\" intersects";
  season.body = RecordBody(test::SmallRobot().body);
  const std::string text = RecordingJson(recording);
  const auto json = nlohmann::json::parse(text);
  CHECK(json["seasons"][0]["speed"].is_null());
  CHECK(json["seasons"][0]["motion"]["samples"] == 0);
  const Recording read = Reread(text);
  CHECK(read.seasons[0].reason == season.reason);
  CHECK(read.seasons[0].body.links.size() == 2);
}

}  // namespace
}  // namespace plsc
