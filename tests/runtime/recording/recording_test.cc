#include "runtime/recording/recording.h"
#include "runtime/life/life.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "tests/runtime/recording/recorded.h"

namespace plsc {
namespace {

TEST_CASE("a recorded body is the assembly in the frames of its links",
          "[recording]") {
  const Phenotype robot = test::SmallRobot();
  const Assembly assembly = Assemble(robot.body);
  const RecordedBody body = RecordBody(robot.body);
  REQUIRE(body.modules.size() == 4);
  CHECK(body.modules[0].id == "1");
  CHECK(body.modules[3].id == "1s3");
  CHECK(body.modules[3].type == ModuleType::kTouchSensor);
  REQUIRE(body.links.size() == 2);
  REQUIRE(body.joints.size() == 1);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(body.links[i].mass == assembly.links[i].mass);
    for (std::size_t k = 0; k < body.links[i].boxes.size(); ++k) {
      const RecordedBox& box = body.links[i].boxes[k];
      const Box& original = assembly.links[i].boxes[k];
      CHECK((body.links[i].rest + box.centre).isApprox(original.centre, 1e-12));
      CHECK(
          Eigen::Quaterniond(box.turn(0), box.turn(1), box.turn(2), box.turn(3))
              .toRotationMatrix()
              .isApprox(original.axes, 1e-9));
    }
  }
  CHECK((body.links[0].rest + body.joints[0].anchor)
            .isApprox(assembly.hinges[0].anchor, 1e-12));
}

TEST_CASE("the mass centre of a recording is the trajectory's", "[recording]") {
  PoseRecorder recorder;
  SimulationOptions options;
  options.duration = 1;
  options.start_height.reset();
  SeasonLife life;
  life.robot = test::SmallRobot();
  life.trajectory = Live(*life.robot, {}, options, {}, &recorder).trajectory;
  const RecordedSeason season = RecordSeason({}, {}, life, recorder.Take());
  const Eigen::Matrix3Xd centres = MassCentres(season);
  // Each 0.2 s is a sample of both.
  REQUIRE(centres.cols() == 51);
  for (Eigen::Index i = 0; i < life.trajectory.time.size(); ++i)
    CHECK(
        centres.col(10 * i).isApprox(life.trajectory.mass_centre.col(i), 1e-9));
}

TEST_CASE("a season without a robot is recorded as such", "[recording]") {
  SeasonLife life;
  life.result.outcome = Outcome::kNotReached;
  life.result.reason = "the life ended";
  const RecordedSeason season = RecordSeason({}, {}, life, {});
  CHECK(season.body.links.empty());
  CHECK(!season.speed);
  CHECK(season.reason == "the life ended");
  CHECK(MassCentres(season).cols() == 0);
}

}  // namespace
}  // namespace plsc
