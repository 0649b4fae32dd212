#include "runtime/scenario/scenario_profile.h"

#include <catch2/catch.hpp>

namespace plsc {

TEST_CASE("The paper's profile is what its text says", "[profile]") {
  const Scenario paper = PaperScenario();
  CHECK(paper.profile == Profile::kPaper);
  CHECK(paper.lives == Lives::kIndependent);
  CHECK(paper.controller == ControllerMode::kCoupled);
  CHECK(paper.measured == MeasuredPoint::kMassCentre);
  CHECK(paper.sensing == Sensing::kImu);
  CHECK(paper.servo.refresh == Refresh::kExact);
  REQUIRE(paper.seasons.size() == 2);
  for (const Season& season : paper.seasons) {
    CHECK(season.duration == 50);
    CHECK_FALSE(season.start_height);
    CHECK(season.physics == PhysicsOptions{});
    CHECK(season.physics.step == 0.005);
    CHECK(season.physics.solver == Solver::kDirect);
    CHECK(season.senses ==
          std::map<std::string, std::string>{{"hot", "False"}});
  }
  CHECK(paper.seasons[0].terrain.type == TerrainType::kFlat);
  CHECK(paper.seasons[1].terrain.type == TerrainType::kTilted);
  CHECK(paper.seasons[1].terrain.tilt == Approx(0.0872664626));
}

TEST_CASE("The published profile is what the authors' program ran",
          "[profile]") {
  const Scenario published = PublishedScenario();
  CHECK(published.profile == Profile::kPublished);
  CHECK(published.controller == ControllerMode::kOpenLoop);
  CHECK(published.measured == MeasuredPoint::kCore);
  CHECK(published.sensing == Sensing::kGiven);
  CHECK(published.servo.refresh == Refresh::kLate);
  REQUIRE(published.seasons.size() == 2);
  const Season& flat = published.seasons[0];
  CHECK(flat.start_height == 0.1);
  CHECK(flat.physics.step == 0.005);
  CHECK(flat.physics.solver == Solver::kDirect);
  CHECK(flat.senses.at("inclined") == "False");
  const Season& tilted = published.seasons[1];
  CHECK(tilted.start_height == 0.1);
  CHECK(tilted.physics.step == 0.003);
  CHECK(tilted.physics.solver == Solver::kIterative);
  CHECK(tilted.physics.solver_iterations == 50);
  CHECK(tilted.senses.at("inclined") == "True");
  // Nothing else is another: the servo's numbers are the authors' in both.
  ServoOptions servo = published.servo;
  servo.refresh = Refresh::kExact;
  CHECK(servo == PaperScenario().servo);
}

TEST_CASE("The swift profile is the paper's with the articulated engine",
          "[profile]") {
  Scenario swift = BothSeasons(Profile::kSwift);
  CHECK(swift.name == "swift");
  CHECK(swift.profile == Profile::kSwift);
  CHECK_FALSE(UsesOde(swift));
  CHECK_FALSE(CheckEngines(swift));
  CHECK_FALSE(SetEngine(swift, EngineKind::kOde));
  CHECK(UsesOde(swift));
  swift.name = "paper";
  swift.profile = Profile::kPaper;
  CHECK(swift == PaperScenario());
}

}  // namespace plsc
