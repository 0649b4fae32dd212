// How fast robots are simulated: microseconds of this thread's processor time
// a step, and simulated time over processor time. Random robots with moving
// servos, a few of each size; wall clock would measure the other programs.
//
//   simulate_bench [SECONDS]    simulated time of each robot, 10 by default

#include <fmt/core.h>

#include <cstdlib>
#include <cstring>
#include <ctime>
#include <random>
#include <vector>

#include "sim/simulate.h"
#include "tests/sim/random_robot.h"

namespace plsc {
namespace {

double ThreadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec);
}

struct Cost {
  double seconds = 0;
  double links = 0, contacts = 0;  // means over robots
  std::int64_t steps = 0;
};

Cost MeasureCost(const std::vector<Phenotype>& robots,
                 const SimulationOptions& options) {
  Cost cost;
  const double count = static_cast<double>(robots.size());
  for (const Phenotype& robot : robots) {
    const double start = ThreadSeconds();
    const Trajectory life = Simulate(robot, Terrain{}, options);
    cost.seconds += ThreadSeconds() - start;
    cost.steps += life.steps;
    cost.links += static_cast<double>(life.joint_angle.rows() + 1) / count;
    cost.contacts += life.contacts.cast<double>().mean() / count;
  }
  return cost;
}

void Run(double duration) {
  constexpr int kRobots = 12;
  fmt::print("{:>8} {:>6} {:>9} {:>10} {:>8} {:>10}\n", "modules", "links",
             "contacts", "step (ms)", "us/step", "x realtime");
  for (const int size : {5, 8, 10, 15}) {
    std::mt19937 random(20200217);  // any; the same robots each time
    std::vector<Phenotype> robots;
    robots.reserve(kRobots);
    for (int i = 0; i < kRobots; ++i)
      robots.push_back(RandomRobot(size, random));
    for (const double step : {0.005, 0.010}) {
      SimulationOptions options;
      options.duration = duration;
      options.physics.step = step;
      const Cost cost = MeasureCost(robots, options);
      const double per_step = cost.seconds / static_cast<double>(cost.steps);
      fmt::print("{:>8} {:>6.1f} {:>9.1f} {:>10.1f} {:>8.1f} {:>10.0f}\n", size,
                 cost.links, cost.contacts, 1e3 * step, 1e6 * per_step,
                 step / per_step);
    }
  }
}

}  // namespace
}  // namespace plsc

int main(int argc, char** argv) {
  // --smoke only shows that it runs; its figures mean nothing.
  const bool smoke = argc > 1 && std::strcmp(argv[1], "--smoke") == 0;
  const double duration = smoke      ? 0.1
                          : argc > 1 ? std::strtod(argv[1], nullptr)
                                     : 10;
  if (!(duration > 0)) {
    fmt::print(stderr, "usage: simulate_bench [--smoke | SECONDS]\n");
    return 2;
  }
  plsc::Run(duration);
  return 0;
}
