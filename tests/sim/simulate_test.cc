#include "sim/simulate.h"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <thread>
#include <vector>

#include "tests/sim/bodies.h"
#include "tests/sim/engines.h"

namespace plsc {
namespace {

SimulationOptions Life(EngineKind engine, double duration) {
  SimulationOptions options = test::With(engine);
  options.duration = duration;
  return options;
}

constexpr EngineKind kOde = EngineKind::kOde;
constexpr Terrain kSlope{TerrainType::kTilted, 5 * M_PI / 180};

/// Four legs: left and right swing and lift, front and back lift in between.
/// With `lift` 0.25 the side legs are down while they swing back; with 0.75
/// while they swing forward, so that the robot walks backwards.
Phenotype Walker(double lift) {
  Body body = LoneCore();
  std::vector<double> offsets;
  for (const Slot side : {Slot::kRight, Slot::kLeft}) {
    const int swing = Mount(body, 0, side, ModuleType::kVerticalJoint);
    const int knee =
        Mount(body, swing, Slot::kFront, ModuleType::kHorizontalJoint);
    Mount(body, knee, Slot::kFront, ModuleType::kBrick);
    // Counter-clockwise is forward at the right, backward at the left.
    offsets.push_back(side == Slot::kRight ? 0 : 0.5);
    offsets.push_back(lift);
  }
  for (const Slot side : {Slot::kFront, Slot::kBack}) {
    const int knee = Mount(body, 0, side, ModuleType::kHorizontalJoint);
    Mount(body, knee, Slot::kFront, ModuleType::kBrick);
    offsets.push_back(lift + 0.5);
  }
  Phenotype robot = WithOscillators(body, 1, 4);
  for (std::size_t i = 0; i < offsets.size(); ++i)
    robot.brain.nodes[i].phase_offset = offsets[i];
  return robot;
}

TEST_CASE("A life is sampled from start to end", "[simulate]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const Phenotype robot = WithOscillators(Cross(), 1, 2);
  const Trajectory life = Simulate(robot, {}, Life(engine, 1.1));
  CHECK(life.outcome == Outcome::kCompleted);
  CHECK(life.steps == 220);
  CHECK(life.interval == 0.2);
  REQUIRE(life.time.size() == 7);
  for (int i = 0; i < 6; ++i) CHECK(life.time(i) == Approx(0.2 * i));
  CHECK(life.time(6) == Approx(1.1));
  CHECK(life.core_position.col(0) == Eigen::Vector3d(0, 0, 0.03));
  CHECK(life.core_orientation.col(0).norm() == 0);
  CHECK(life.mass_centre.col(0).isApprox(Eigen::Vector3d(0, 0, 0.03), 1e-12));
  CHECK(life.joint_angle.rows() == 4);
  CHECK(life.joint_angle.col(0).norm() == 0);
  CHECK(life.contacts(0) == 0);
  CHECK(life.contacts(6) > 0);
}

TEST_CASE("A joint follows its oscillator as a first-order lag", "[simulate]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  // In free flight, joint against brick: the servo is strong enough there to
  // be at the speed it is told within a step. Updates at 8 Hz, each holding
  // speed = 0.9 (target - angle).
  Body body = LoneCore();
  Mount(body, 0, Slot::kFront, ModuleType::kHorizontalJoint);
  Phenotype robot = WithOscillators(body, 10, 8);
  SimulationOptions options = Life(engine, 4);
  options.physics.gravity = 0;
  options.start_height = 10;
  options.sample_interval = 0.125;
  const Trajectory life = Simulate(robot, {}, options);
  double angle = 0;
  for (int update = 0; update < 32; ++update) {
    INFO("update " << update);
    CHECK(life.joint_angle(0, update) == Approx(angle).margin(1e-3));
    const double wave = 5 * std::sin(2 * M_PI * 0.125 * update / 8);
    const double target = std::min(std::max(2 * wave, -1.0), 1.0) * M_PI / 4;
    angle += 0.125 * 0.9 * (target - angle);
  }
}

TEST_CASE("Robots without joints fall and rest", "[simulate]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const Trajectory life = Simulate({LoneCore(), {}}, {}, Life(engine, 2));
  const Eigen::Index last = life.time.size() - 1;
  CHECK(life.outcome == Outcome::kCompleted);
  CHECK(life.joint_angle.rows() == 0);
  CHECK(life.core_position(2, last) == Approx(0.0225).margin(0.002));
  CHECK(life.core_position.col(last).head<2>().norm() < 1e-6);
  CHECK(life.contacts(last) == 4);
}

TEST_CASE("A robot that overlaps is not simulated", "[simulate]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  // Four bricks in a ring, entered by two joints that do not share a link.
  Body body = LoneCore();
  const int a = Mount(body, 0, Slot::kFront, ModuleType::kVerticalJoint);
  const int b = Mount(body, 0, Slot::kRight, ModuleType::kVerticalJoint);
  int brick = Mount(body, a, Slot::kFront, ModuleType::kBrick);
  brick = Mount(body, brick, Slot::kRight, ModuleType::kBrick);
  Mount(body, brick, Slot::kFront, ModuleType::kBrick);
  brick = Mount(body, b, Slot::kFront, ModuleType::kBrick);
  brick = Mount(body, brick, Slot::kLeft, ModuleType::kBrick);
  Mount(body, brick, Slot::kFront, ModuleType::kBrick);
  const Trajectory life = Simulate({body, {}}, {}, Life(engine, 1));
  CHECK(life.outcome == Outcome::kOverlapping);
  CHECK(life.reason.find("intersect in the rest pose") != std::string::npos);
  CHECK(life.steps == 0);
  CHECK(life.time.size() == 0);
  CHECK(life.core_position.cols() == 0);
}

TEST_CASE("A life that goes wrong keeps what came before", "[simulate]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  SimulationOptions options = Life(engine, 5);
  options.start_height = 1000;
  options.physics.gravity = 12.6;  // 50 m/s after 793.65 steps of fall
  options.physics.damping = 0;
  const Trajectory life = Simulate({Cross(), {}}, {}, options);
  CHECK(life.outcome == Outcome::kUnstable);
  CHECK(life.reason.find("more than max_speed, 50 m/s") != std::string::npos);
  CHECK(life.time.size() == 20);  // 0 to 3.8 s
  CHECK(life.core_position.cols() == 20);
  CHECK(life.steps == Approx(3.97 / 0.005).margin(2));
}

TEST_CASE("A robot with legs walks the way they push", "[simulate]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  for (const double lift : {0.25, 0.75}) {
    const Trajectory life = Simulate(Walker(lift), {}, Life(engine, 20));
    REQUIRE(life.outcome == Outcome::kCompleted);
    const Eigen::Vector3d end = life.core_position.col(life.time.size() - 1);
    // 0.34 m forward or 0.29 m backward when written; steps of 2.5 ms lead
    // 2 % farther. Its sides are alike, so it goes straight.
    CHECK((lift < 0.5 ? end.y() : -end.y()) == Approx(0.32).margin(0.08));
    CHECK(std::abs(end.x()) < 0.02);
  }
}

TEST_CASE("The slope slows a climber", "[simulate]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  const auto progress = [&](const Terrain& terrain) {
    const Trajectory life = Simulate(Walker(0.25), terrain, Life(engine, 20));
    return life.core_position(1, life.time.size() - 1);
  };
  CHECK(progress(kSlope) < progress({}) - 0.02);
}

TEST_CASE("Touch and loops act in coupled mode only", "[simulate]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  Body body = Cross();
  for (int brick = 2; brick <= 8; brick += 2)
    Mount(body, brick, Slot::kFront, ModuleType::kTouchSensor);
  // Slow enough for the servos to follow and the legs to reach the ground.
  Phenotype robot = WithOscillators(body, 1, 8);
  const Phenotype plain = robot;
  for (int sensor = 9; sensor <= 12; ++sensor) {
    robot.brain.nodes.push_back({NodeType::kInput, sensor, 0.5, 0, 0, 0});
    robot.brain.connections.push_back({sensor - 5, sensor - 9, 0.8});
  }
  SimulationOptions open = Life(engine, 4), coupled = Life(engine, 4);
  coupled.controller = ControllerMode::kCoupled;
  const auto hash = [](const Phenotype& phenotype,
                       const SimulationOptions& options) {
    return Simulate(phenotype, {}, options).state_hash;
  };
  CHECK(hash(robot, open) == hash(plain, open));
  CHECK(hash(plain, coupled) == hash(plain, open));
  CHECK(hash(robot, coupled) != hash(robot, open));
}

TEST_CASE("Big bodies are simulated as others are", "[simulate]") {
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  Body chain = LoneCore();
  int end = 0;
  for (int i = 1; i < 200; ++i)
    end = Mount(chain, end, Slot::kFront,
                i % 20 == 0 ? ModuleType::kVerticalJoint : ModuleType::kBrick);
  const Trajectory life =
      Simulate(WithOscillators(chain, 2, 3), {}, Life(engine, 0.5));
  CHECK(life.outcome == Outcome::kCompleted);
  CHECK(life.joint_angle.rows() == 9);
}

TEST_CASE("Robots of very many links are solved iteratively", "[simulate]") {
  // By ODE; the articulated engine has one method for all.
  Body chain = LoneCore();
  int end = 0;
  for (int i = 1; i < 200; ++i)
    end = Mount(
        chain, end, Slot::kFront,
        i % 2 == 0 ? ModuleType::kVerticalJoint : ModuleType::kHorizontalJoint);
  const Phenotype robot = WithOscillators(chain, 2, 3);
  SimulationOptions iterative = Life(kOde, 0.1);
  iterative.physics.solver = Solver::kIterative;
  const Trajectory life = Simulate(robot, {}, Life(kOde, 0.1));
  CHECK(life.outcome == Outcome::kCompleted);
  CHECK(life.joint_angle.rows() == 199);
  CHECK(life.state_hash == Simulate(robot, {}, iterative).state_hash);
}

struct Job {
  Phenotype robot;
  Terrain terrain;
  SimulationOptions options;
};

/// Every way to solve a step.
std::vector<PhysicsOptions> Ways() {
  std::vector<PhysicsOptions> ways(3);
  ways[1].solver = Solver::kIterative;
  ways[2].engine = EngineKind::kArticulated;
  return ways;
}

std::vector<Job> Jobs(const PhysicsOptions& physics) {
  std::vector<Job> jobs;
  for (int i = 0; i < 20; ++i) {
    Job job{i % 2 == 0 ? Walker(0.25)
                       : WithOscillators(Cross(), 1 + i, 2 + 0.3 * i),
            i % 3 == 0 ? kSlope : Terrain{}, Life(kOde, 1)};
    job.options.physics = physics;
    jobs.push_back(job);
  }
  return jobs;
}

std::vector<std::uint64_t> HashesOf(const std::vector<Job>& jobs) {
  std::vector<std::uint64_t> hashes;
  hashes.reserve(jobs.size());
  for (const Job& job : jobs)
    hashes.push_back(Simulate(job.robot, job.terrain, job.options).state_hash);
  return hashes;
}

TEST_CASE("The same bits after any history and in any thread", "[simulate]") {
  for (const PhysicsOptions& way : Ways()) {
    const std::vector<Job> jobs = Jobs(way);
    const auto alone = HashesOf({jobs[3]});
    const auto expected = HashesOf(jobs);
    CHECK(alone[0] == expected[3]);
    const std::vector<Job> backwards(jobs.rbegin(), jobs.rend());
    const auto reversed = HashesOf(backwards);
    CHECK(std::equal(expected.begin(), expected.end(), reversed.rbegin()));
    std::vector<std::uint64_t> first, second;
    std::thread a([&] { first = HashesOf(jobs); });
    std::thread b([&] { second = HashesOf(backwards); });
    a.join();
    b.join();
    CHECK(first == expected);
    CHECK(second == reversed);
  }
}

/// What another process, forked from this one, computes.
std::uint64_t HashInChild(const Job& job) {
  int ends[2] = {};
  REQUIRE(pipe(ends) == 0);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const std::uint64_t hash = HashesOf({job})[0];
    const ssize_t written = write(ends[1], &hash, sizeof hash);
    _exit(written == sizeof hash ? 0 : 1);
  }
  std::uint64_t hash = 0;
  CHECK(read(ends[0], &hash, sizeof hash) == sizeof hash);
  CHECK(waitpid(child, nullptr, 0) == child);
  close(ends[0]);
  close(ends[1]);
  return hash;
}

TEST_CASE("The same bits in another process", "[simulate]") {
  for (const PhysicsOptions& way : Ways()) {
    const std::vector<Job> jobs = Jobs(way);
    CHECK(HashInChild(jobs[4]) == HashesOf(jobs)[4]);
  }
}

TEST_CASE("The solvers agree on where a robot goes", "[simulate]") {
  SimulationOptions direct = Life(kOde, 10), iterative = Life(kOde, 10);
  iterative.physics.solver = Solver::kIterative;
  iterative.physics.solver_iterations = 200;
  const Trajectory a = Simulate(Walker(0.25), {}, direct);
  const Trajectory b = Simulate(Walker(0.25), {}, iterative);
  CHECK(a.state_hash != b.state_hash);
  // The iterative one falls a sixth short over 20 s: its friction gives way.
  const double way = a.core_position(1, a.time.size() - 1);
  CHECK(b.core_position(1, b.time.size() - 1) == Approx(way).epsilon(0.35));
}

}  // namespace
}  // namespace plsc
