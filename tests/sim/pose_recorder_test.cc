#include "sim/pose_recorder.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/simulate.h"
#include "tests/sim/bodies.h"

namespace plsc {
namespace {

// A core, a joint with a brick before it, and a sensor below none of them.
Phenotype Walker() {
  Body body = LoneCore();
  const int joint = Mount(body, 0, Slot::kFront, ModuleType::kHorizontalJoint);
  Mount(body, joint, Slot::kFront, ModuleType::kBrick);
  Mount(body, 0, Slot::kLeft, ModuleType::kTouchSensor);
  return WithOscillators(body, 1, 2);
}

SimulationOptions Seconds(double duration) {
  SimulationOptions options;
  options.duration = duration;
  options.start_height.reset();
  return options;
}

TEST_CASE("who watches a life changes nothing in it", "[pose_recorder]") {
  PoseRecorder recorder;
  const auto alone = Simulate(Walker(), {}, Seconds(2));
  const auto watched = Live(Walker(), {}, Seconds(2), {}, &recorder);
  CHECK(alone.state_hash == watched.trajectory.state_hash);
  CHECK(alone.mass_centre == watched.trajectory.mass_centre);
}

TEST_CASE("poses are recorded from the start to the end, 20 ms apart",
          "[pose_recorder]") {
  PoseRecorder recorder;
  // 2.013 s are 403 steps of 5 ms: the end is no multiple of 20 ms.
  const Lived lived = Live(Walker(), {}, Seconds(2.013), {}, &recorder);
  const Motion motion = recorder.Take();
  REQUIRE(motion.samples() == 102);
  CHECK(motion.steps[1] == 4);
  CHECK(motion.steps.back() == 403);
  CHECK(motion.TimeOf(101) == Approx(2.015));
  REQUIRE(motion.position.rows() == 6);  // two links
  REQUIRE(motion.turn.rows() == 8);
  REQUIRE(motion.joint_angle.rows() == 1);
  REQUIRE(motion.touch.rows() == 1);
  // The same states as those that the life went through.
  const Eigen::Index last = motion.samples() - 1;
  for (std::size_t link = 0; link < 2; ++link)
    CHECK(motion.position.col(last).segment<3>(
              3 * static_cast<Eigen::Index>(link)) ==
          lived.end.poses[link].position);
  CHECK(motion.joint_angle(0, last) ==
        lived.trajectory.joint_angle(0, lived.trajectory.time.size() - 1));
  // Neighbours never jump to the other quaternion of the same turn.
  for (Eigen::Index i = 0; i < last; ++i)
    for (const Eigen::Index link : {0, 4})
      CHECK(motion.turn.col(i).segment<4>(link).dot(
                motion.turn.col(i + 1).segment<4>(link)) > 0.99);
}

TEST_CASE("touch is recorded as the sensor felt it", "[pose_recorder]") {
  // A limb with a sensor at its tip that slowly bows to the ground and back:
  // 23 mm below the hinge of a limb of 10 cm is a bow of 13 degrees.
  Body body = LoneCore();
  const int joint = Mount(body, 0, Slot::kFront, ModuleType::kHorizontalJoint);
  const int brick = Mount(body, joint, Slot::kFront, ModuleType::kBrick);
  Mount(body, brick, Slot::kFront, ModuleType::kTouchSensor);
  PoseRecorder recorder;
  Live(WithOscillators(body, 1, 10), {}, Seconds(10), {}, &recorder);
  const Motion motion = recorder.Take();
  REQUIRE(motion.touch.rows() == 1);
  int bowed = 0;
  int felt = 0;
  for (Eigen::Index i = 0; i < motion.samples(); ++i) {
    // A limb that is up cannot touch.
    if (motion.joint_angle(0, i) < 0) CHECK(motion.touch(0, i) == 0);
    if (motion.joint_angle(0, i) < 0.5) continue;
    ++bowed;
    felt += motion.touch(0, i);
  }
  // One that stands on its tip touches in nearly every step.
  CHECK(bowed > 50);
  CHECK(felt > 0.7 * bowed);
  CHECK(motion.touch.minCoeff() == 0);
  CHECK(motion.touch.maxCoeff() == 1);
}

TEST_CASE("long lives and large robots are sampled less often",
          "[pose_recorder]") {
  struct Row {
    const char* why;
    double duration;
    double step;
    int links;
    std::int64_t stride;
  };
  const std::vector<Row> rows = {
      {"a season", 50, 0.005, 10, 4},
      {"steps that do not divide 20 ms: not more often", 50, 0.003, 10, 7},
      {"steps longer than 20 ms", 50, 0.05, 10, 1},
      {"1000 s of 15 links just fit", 1000, 0.005, 15, 4},
      {"5000 s of 15 links: 0.1 s", 5000, 0.005, 15, 20},
      {"256 links", 50, 0.005, 256, 4},
      {"256 links for 5000 s: 1.71 s", 5000, 0.005, 256, 342},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      SimulationOptions options;
      options.duration = row.duration;
      options.physics.step = row.step;
      CHECK(ReplayStride(options, row.links) == row.stride);
    }
  }
}

TEST_CASE("a watcher can end a life", "[pose_recorder]") {
  class Impatient : public Watcher {
   public:
    void Begin(const Phenotype&, const SimulationOptions&, double) override {}
    bool See(const World&, std::int64_t step) override { return step < 100; }
  };
  Impatient watcher;
  const Trajectory trajectory =
      Live(Walker(), {}, Seconds(50), {}, &watcher).trajectory;
  CHECK(trajectory.outcome == Outcome::kStopped);
  CHECK(trajectory.reason == "by the user after 0.5 s");
  CHECK(trajectory.steps == 100);
  CHECK(trajectory.time.size() == 3);  // 0, 0.2, 0.4 s
}

TEST_CASE("poses that are no numbers are not recorded", "[pose_recorder]") {
  const Phenotype robot = {LoneCore(), {}};
  const SimulationOptions options = Seconds(1);
  World world(Assemble(robot.body), {}, options);
  PoseRecorder recorder;
  recorder.Begin(robot, options, 0);
  recorder.See(world, 0);
  LinkPose pose = world.PoseOf(0);
  for (const double x : {1e12, std::nan(""), HUGE_VAL}) {
    pose.position.x() = x;
    world.SetState(0, pose, {{0, 0, 0}, {0, 0, 0}});
    recorder.See(world, 4);
  }
  const Motion motion = recorder.Take();
  CHECK(motion.samples() == 1);
  CHECK(motion.position.allFinite());
}

TEST_CASE("a robot that is not simulated leaves no samples",
          "[pose_recorder]") {
  PoseRecorder recorder;
  SimulationOptions options = Seconds(1);
  options.max_links = 1;
  Live(Walker(), {}, options, {}, &recorder);
  CHECK(recorder.Take().samples() == 0);
}

}  // namespace
}  // namespace plsc
