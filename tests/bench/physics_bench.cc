// What a step of a robot costs in the articulated engine, or in ODE: beside
// MuJoCo on the same robots (if it was found when configuring), by part, and on
// the heap. Robots are random, of five sizes, and evolved (tests/data). Both
// engines take turns in one process and processor time of the thread is
// counted, so that other programs disturb ratios little. Reports; asserts
// nothing.
//
//   physics_bench [--smoke | SECONDS] [--ode]   simulated time of each robot; 5

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "sim/controller.h"
#include "sim/schedule.h"
#include "sim/simulate.h"
#include "tests/bench/evolved_robots.h"
#include "tests/bench/stopwatch.h"
#include "tests/heap.h"
#include "tests/sim/random_robot.h"
#include "tests/sim/terrains.h"
#ifdef PLSC_HAS_MUJOCO
#include "tests/bench/mujoco_robot.h"
#endif

namespace plsc::bench {
namespace {

constexpr int kRobots = 12;           // of each size
constexpr int kRounds = 3;            // of the same life; the quickest counts
constexpr int kTurn = 50;             // steps an engine takes in turn
constexpr unsigned kSeed = 20200217;  // any; the same robots each time

EngineKind engine = EngineKind::kArticulated;  // NOLINT: of the whole program

/// Of `swift`, but open-loop: the robots' touch is not told in MuJoCo.
SimulationOptions Options(double duration) {
  SimulationOptions options;
  options.duration = duration;
  options.start_height.reset();
  options.physics.engine = engine;
  return options;
}

std::vector<Phenotype> Robots(int size) {
  std::mt19937 random(kSeed);
  std::vector<Phenotype> robots;
  robots.reserve(kRobots);
  for (int i = 0; i < kRobots; ++i) robots.push_back(RandomRobot(size, random));
  return robots;
}

/// The same brain and servo for any engine's robot.
class Brains {
 public:
  Brains(const Phenotype& robot, const SimulationOptions& options)
      : controller_(robot, options.controller),
        schedule_(options.servo, options.physics.step),
        servo_(options.servo),
        touched_(robot.body.modules.size()) {}

  template <typename Robot>
  void Act(std::int64_t step, Robot& robot) {
    const std::optional<double> due = schedule_.Due(step);
    if (!due) return;
    const auto& outputs = controller_.Update(*due, touched_);
    for (int i = 0; i < robot.joints(); ++i)
      robot.SetJointSpeed(i, ServoSpeed(outputs[static_cast<std::size_t>(i)],
                                        robot.JointAngle(i), servo_));
  }

 private:
  Controller controller_;
  RefreshSchedule schedule_;
  ServoOptions servo_;
  std::vector<bool> touched_;
};

/// Sums over all robots' turns.
struct Cost {
  double seconds = 0;
  double contacts = 0;
  double bend = 0;  ///< rad, of the joints' absolute angles: do servos work?
  double joints = 0;
};

template <typename Robot>
double TakeTurn(Robot& robot, Brains& brains, std::int64_t from) {
  const double begin = CpuSeconds();
  for (std::int64_t step = from; step < from + kTurn; ++step) {
    brains.Act(step, robot);
    (void)robot.Step();
  }
  return CpuSeconds() - begin;
}

template <typename Robot>
void Look(const Robot& robot, Cost& cost) {
  cost.contacts += robot.contacts();
  for (int i = 0; i < robot.joints(); ++i)
    cost.bend += std::abs(robot.JointAngle(i));
  cost.joints += robot.joints();
}

struct Comparison {
  Cost ours, mujoco;
  double turns = 0, links = 0;

  double Microseconds(const Cost& cost) const {
    return 1e6 * cost.seconds / (turns * kTurn);
  }
};

#ifdef PLSC_HAS_MUJOCO
struct Peer {
  MujocoRobot robot;
  Brains brains;
  Peer(const Phenotype& phenotype, const Assembly& assembly,
       const Terrain& terrain, const SimulationOptions& options)
      : robot(MjcfOf(assembly, terrain, options,
                     StartOf(assembly, terrain, options, {}))),
        brains(phenotype, options) {}
  double TakeTurnAt(std::int64_t step) { return TakeTurn(robot, brains, step); }
  void LookAt(Cost& cost) const { Look(robot, cost); }
};
#else
struct Peer {
  Peer(const Phenotype&, const Assembly&, const Terrain&,
       const SimulationOptions&) {}
  double TakeTurnAt(std::int64_t) { return 0; }
  void LookAt(Cost&) const {}
};
#endif

/// One robot's life, `kRounds` times; every turn's quickest is added.
void CompareOne(const Phenotype& phenotype, const Terrain& terrain,
                const SimulationOptions& options, Comparison& sum) {
  const Assembly assembly = Assemble(phenotype.body);
  const std::int64_t turns = StepsOf(options) / kTurn;
  std::vector<double> ours(static_cast<std::size_t>(turns), 1e9);
  std::vector<double> mujoco = ours;
  for (int round = 0; round < kRounds; ++round) {
    World world(assembly, terrain, options);
    Brains brains(phenotype, options);
    Peer peer(phenotype, assembly, terrain, options);
    for (std::size_t i = 0; i < ours.size(); ++i) {
      const auto step = static_cast<std::int64_t>(i) * kTurn;
      ours[i] = std::min(ours[i], TakeTurn(world, brains, step));
      mujoco[i] = std::min(mujoco[i], peer.TakeTurnAt(step));
      if (round > 0) continue;
      Look(world, sum.ours);
      peer.LookAt(sum.mujoco);
    }
  }
  for (const double seconds : ours) sum.ours.seconds += seconds;
  for (const double seconds : mujoco) sum.mujoco.seconds += seconds;
  sum.turns += static_cast<double>(turns);
  sum.links += static_cast<double>(assembly.links.size());
}

Comparison Compare(const std::vector<Phenotype>& robots, const Terrain& terrain,
                   const SimulationOptions& options) {
  Comparison sum;
  for (const Phenotype& phenotype : robots)
    CompareOne(phenotype, terrain, options, sum);
  sum.links /= static_cast<double>(robots.size());
  return sum;
}

void PrintComparison(double duration) {
  fmt::print("speed at 5 ms, {} robots of each size, {} s each\n", kRobots,
             duration);
  fmt::print(
      "{:>7} {:>5} {:>6} | {:>7} {:>6} {:>8} {:>5} | {:>7} {:>8} {:>5} |"
      " {:>10}\n",
      "modules", "links", "ground", "us/step", "x real", "contacts", "bend",
      "MuJoCo", "contacts", "bend", "MuJoCo/us");
  const auto line = [&](const std::string& name, double degrees,
                        const std::vector<Phenotype>& robots) {
    const Terrain terrain = degrees > 0 ? test::Slope(degrees) : Terrain{};
    const Comparison c = Compare(robots, terrain, Options(duration));
    const double ours = c.Microseconds(c.ours);
    const double theirs = c.Microseconds(c.mujoco);
    fmt::print("{:>7} {:>5.1f} {:>6} | {:>7.2f} {:>6.0f} {:>8.1f} {:>5.2f} |",
               name, c.links, degrees > 0 ? "5 deg" : "flat", ours, 5000 / ours,
               c.ours.contacts / c.turns, c.ours.bend / c.ours.joints);
    if (theirs > 0)
      fmt::print(" {:>7.1f} {:>8.1f} {:>5.2f} | {:>10.2f}\n", theirs,
                 c.mujoco.contacts / c.turns, c.mujoco.bend / c.mujoco.joints,
                 theirs / ours);
    else
      fmt::print(" not found when configuring\n");
  };
  for (const int size : {5, 8, 10, 15, 17})
    for (const double degrees : {0.0, 5.0})
      line(std::to_string(size), degrees, Robots(size));
  for (const double degrees : {0.0, 5.0})
    line("evolved", degrees, EvolvedRobots(degrees > 0));
  fmt::print(
      "RoboGen, 17 parts, 5 ms: 41 to 58 x real time (measured "
      "elsewhere, on another machine)\n\n");
}

/// Seconds of a step's parts, the clock's own cost taken off.
class Parts {
 public:
  Parts() {
    constexpr int kReads = 20000;
    const double begin = CpuSeconds();
    for (int i = 0; i < kReads; ++i) (void)CpuSeconds();
    read_ = (CpuSeconds() - begin) / kReads;
  }
  void Start() { latest_ = CpuSeconds(); }
  void Lap(double& part) {
    const double now = CpuSeconds();
    part += now - latest_ - read_;
    latest_ = now;
  }
  double brain = 0, collision = 0, solver = 0, rest = 0;

 private:
  double read_ = 0, latest_ = 0;
};

void PrintParts(double duration) {
  const SimulationOptions options = Options(duration);
  fmt::print("parts of a step, us (share)\n{:>7} {:>14} {:>14} {:>14} {:>14}\n",
             "modules", "collision", "solver", "brain", "rest");
  for (const int size : {5, 8, 10, 15}) {
    Parts parts;
    double steps = 0;
    for (const Phenotype& phenotype : Robots(size)) {
      World world(Assemble(phenotype.body), {}, options);
      Brains brains(phenotype, options);
      world.Listen([&](StepPart part) {
        parts.Lap(part == StepPart::kCollision ? parts.collision
                  : part == StepPart::kSolver  ? parts.solver
                                               : parts.rest);
      });
      for (std::int64_t step = 0; step < StepsOf(options); ++step) {
        parts.Start();
        brains.Act(step, world);
        parts.Lap(parts.brain);
        if (!world.Step()) break;
        ++steps;
      }
    }
    const double all =
        parts.brain + parts.collision + parts.solver + parts.rest;
    fmt::print("{:>7}", size);
    for (const double part :
         {parts.collision, parts.solver, parts.brain, parts.rest})
      fmt::print(" {:>7.2f} ({:>3.0f} %)", 1e6 * part / steps,
                 100 * part / all);
    fmt::print("\n");
  }
  fmt::print("\n");
}

void PrintHeap(double duration) {
  if (!test::HeapIsCounted()) return;
  fmt::print(
      "heap of one robot's life, most of {} robots\n{:>7} {:>10} "
      "{:>22}\n",
      kRobots, "modules", "KiB", "calls after 1 s");
  for (const int size : {5, 8, 10, 15}) {
    std::size_t most = 0, calls = 0;
    for (const Phenotype& phenotype : Robots(size)) {
      const std::size_t before = test::HeapBytes();
      test::ResetHeapPeak();
      const SimulationOptions options = Options(duration);
      World world(Assemble(phenotype.body), {}, options);
      Brains brains(phenotype, options);
      const std::int64_t warm = NearestStep(1, options.physics.step);
      std::size_t at_warm = test::HeapCalls();
      for (std::int64_t step = 0; step < StepsOf(options); ++step) {
        if (step == warm) at_warm = test::HeapCalls();
        brains.Act(step, world);
        if (!world.Step()) break;
      }
      calls = std::max(calls, test::HeapCalls() - at_warm);
      most = std::max(most, test::HeapPeak() - before);
    }
    fmt::print("{:>7} {:>10.0f} {:>22}\n", size,
               static_cast<double>(most) / 1024, calls);
  }
}

}  // namespace
}  // namespace plsc::bench

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[argc - 1], "--ode") == 0) {
    plsc::bench::engine = plsc::EngineKind::kOde;
    --argc;
  }
  // --smoke only shows that it runs; its figures mean nothing.
  const bool smoke = argc > 1 && std::strcmp(argv[1], "--smoke") == 0;
  const double duration = smoke      ? 0.25
                          : argc > 1 ? std::strtod(argv[1], nullptr)
                                     : 5;
  if (!(duration > 0)) {
    fmt::print(stderr, "usage: physics_bench [--smoke | SECONDS] [--ode]\n");
    return 2;
  }
  plsc::bench::PrintComparison(duration);
  plsc::bench::PrintParts(duration);
  plsc::bench::PrintHeap(duration);
  return 0;
}
