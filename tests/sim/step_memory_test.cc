// The heap that a simulated robot takes. Counted for the whole program, ODE
// included; a program of its own, as it replaces malloc.

#include <catch2/catch.hpp>
#include <optional>
#include <random>

#include "sim/controller.h"
#include "sim/schedule.h"
#include "sim/simulate.h"
#include "tests/heap.h"
#include "tests/sim/engines.h"
#include "tests/sim/random_robot.h"
#include "tests/sim/terrains.h"

namespace plsc {
namespace {

// Of the issue that asked for it: 1 MiB a robot.
constexpr std::size_t kMostBytes = std::size_t{1} << 20;

TEST_CASE("The counter of the heap counts", "[memory]") {
  if (!test::HeapIsCounted()) return;
  const std::size_t calls = test::HeapCalls(), bytes = test::HeapBytes();
  test::ResetHeapPeak();
  {
    const std::vector<char> memory(10000);
    CHECK(test::HeapCalls() == calls + 1);
    CHECK(test::HeapBytes() >= bytes + memory.size());
  }
  CHECK(test::HeapBytes() == bytes);
  CHECK(test::HeapPeak() >= bytes + 10000);
}

/// Lets the robot live and gives how often its steps asked the heap, the first
/// `warm_up` apart, in which buffers grow to what the robot needs there.
std::size_t CallsOfSteps(const Phenotype& robot, const Terrain& terrain,
                         const SimulationOptions& options, int warm_up,
                         int steps) {
  World world(Assemble(robot.body), terrain, options);
  Controller controller(robot, ControllerMode::kCoupled);
  RefreshSchedule schedule(options.servo, options.physics.step);
  std::size_t before = 0;
  for (int step = 0; step < warm_up + steps; ++step) {
    if (step == warm_up) before = test::HeapCalls();
    if (const std::optional<double> due = schedule.Due(step)) {
      const auto& outputs = controller.Update(*due, world.touched());
      for (int joint = 0; joint < world.joints(); ++joint)
        world.SetJointSpeed(joint,
                            ServoSpeed(outputs[static_cast<std::size_t>(joint)],
                                       world.JointAngle(joint), options.servo));
    }
    if (!world.Step()) FAIL("the world went wrong");
  }
  return test::HeapCalls() - before;
}

TEST_CASE("Steps ask for no memory", "[memory]") {
  if (!test::HeapIsCounted()) {
    WARN("not counted under a sanitizer");
    return;
  }
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  SimulationOptions options = test::With(engine);
  options.start_height.reset();
  for (const Terrain& terrain : test::AllTerrains()) {
    CAPTURE(static_cast<int>(terrain.type));
    std::mt19937 random(5);  // any
    for (const int size : {2, 5, 8, 15}) {
      CAPTURE(size);
      const Phenotype robot = RandomRobot(size, random);
      CHECK(CallsOfSteps(robot, terrain, options, test::Of(engine, 200, 1),
                         2800) == 0);
    }
  }
}

TEST_CASE("Nor do the articulated engine's of robots of any size", "[memory]") {
  if (!test::HeapIsCounted()) return;
  SimulationOptions options = test::With(EngineKind::kArticulated);
  options.start_height.reset();
  Body pair = LoneCore();
  Mount(pair, 0, Slot::kFront, ModuleType::kBrick);
  for (const Body& body :
       {LoneCore(), pair, Comb(63), Comb(127), Comb(options.max_links - 1)}) {
    const Assembly assembly = Assemble(body);
    CAPTURE(assembly.links.size());
    for (const Terrain& terrain :
         {Terrain{}, test::RoughGround(1, 0.02, 0.2)}) {
      CAPTURE(static_cast<int>(terrain.type));
      CHECK(CallsOfSteps(WithOscillators(body, 1, 2), terrain, options, 1,
                         200) == 0);
    }
  }
}

TEST_CASE("A simulated robot takes less than 1 MiB", "[memory]") {
  if (!test::HeapIsCounted()) return;
  const EngineKind engine = test::EachEngine();
  CAPTURE(engine);
  std::mt19937 random(5);  // any
  for (const Terrain& terrain : test::AllTerrains()) {
    CAPTURE(static_cast<int>(terrain.type));
    const Phenotype robot = RandomRobot(15, random);
    SimulationOptions options = test::With(engine);
    options.duration = 5;
    // As many samples as of a season of 50 s.
    options.sample_interval = 0.02;
    const std::size_t before = test::HeapBytes();
    test::ResetHeapPeak();
    {
      const Trajectory life = Simulate(robot, terrain, options);
      CHECK(life.outcome == Outcome::kCompleted);
      CHECK(test::HeapPeak() - before < kMostBytes);
    }
    CHECK(test::HeapBytes() == before);  // and gives all of it back
  }
}

}  // namespace
}  // namespace plsc
