// How true each solver and step are, and what they cost: rank correlations of
// speeds over random robots with the direct solver at 1 ms. Random genotypes
// of the evolver, developed; those without joints or that overlap are drawn
// again. Reports; asserts nothing.
//
//   solver_bench [--smoke | ROBOTS SECONDS]   100 robots, 10 s each

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "runtime/develop/develop.h"
#include "runtime/vary/initialise.h"
#include "sim/measures.h"
#include "sim/overlap.h"
#include "sim/simulate.h"
#include "tests/bench/stopwatch.h"

namespace plsc::bench {
namespace {

struct Way {
  const char* name;
  Solver solver;
  double step;  // s
};

// The first is the reference.
constexpr Way kWays[] = {
    {"direct, 1 ms", Solver::kDirect, 0.001},
    {"direct, 2.5 ms", Solver::kDirect, 0.0025},
    {"direct, 5 ms (default)", Solver::kDirect, 0.005},
    {"direct, 10 ms (fast)", Solver::kDirect, 0.010},
    {"iterative 50, 3 ms", Solver::kIterative, 0.003},
    {"iterative 50, 5 ms", Solver::kIterative, 0.005},
};

/// `inclined` is False: the body for flat ground.
std::vector<Phenotype> RandomRobots(std::size_t count) {
  std::vector<Phenotype> robots;
  for (std::uint64_t id = 1; robots.size() < count; ++id) {
    Rng rng({20200217, 0, id, Purpose::kInitialise});  // any seed
    const Genotype genotype = Initialise(GenotypeOptions{}, rng);
    const std::optional<Phenotype> robot = Develop(
        genotype, Environment{std::vector<double>(genotype.states.size())});
    if (!robot) continue;
    const Assembly assembly = Assemble(robot->body);
    if (!assembly.hinges.empty() && FindOverlaps(assembly).empty())
      robots.push_back(*robot);
  }
  return robots;
}

struct Measured {
  std::vector<double> uphill;  ///< m/s, the paper's Speed
  std::vector<double> any;     ///< m/s, of displacement whatever its direction
  double seconds = 0;
  double lived = 0;                 ///< s
  std::vector<std::string> failed;  ///< why lives were not completed
};

Measured Try(const std::vector<Phenotype>& robots, const Way& way,
             double duration) {
  Measured measured;
  SimulationOptions options;
  options.duration = duration;
  options.start_height.reset();
  options.controller = ControllerMode::kCoupled;
  options.physics.solver = way.solver;
  options.physics.step = way.step;
  for (const Phenotype& robot : robots) {
    const double begin = CpuSeconds();
    const Trajectory life = Simulate(robot, {}, options);
    measured.seconds += CpuSeconds() - begin;
    measured.lived += static_cast<double>(life.steps) * way.step;
    const Behaviour behaviour = Measure(life, 1, MeasuredPoint::kMassCentre);
    if (!behaviour.is_valid) measured.failed.push_back(life.reason);
    measured.uphill.push_back(behaviour.displacement_velocity_hill);
    measured.any.push_back(behaviour.displacement_velocity);
  }
  return measured;
}

/// 0 the least; equals share the mean of their ranks.
std::vector<double> Ranks(const std::vector<double>& values) {
  std::vector<double> ranks;
  for (const double value : values) {
    double below = 0, equal = 0;
    for (const double other : values) {
      below += other < value ? 1 : 0;
      equal += other == value ? 1 : 0;
    }
    ranks.push_back(below + (equal - 1) / 2);
  }
  return ranks;
}

/// Spearman's.
double RankCorrelation(const std::vector<double>& a,
                       const std::vector<double>& b) {
  const std::vector<double> x = Ranks(a), y = Ranks(b);
  const double mean = (static_cast<double>(x.size()) - 1) / 2;
  double xx = 0, yy = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean) * (x[i] - mean);
    yy += (y[i] - mean) * (y[i] - mean);
    xy += (x[i] - mean) * (y[i] - mean);
  }
  return xy / std::sqrt(xx * yy);
}

/// Of the displacement; sum of differences over sum of values.
double RelativeError(const std::vector<double>& values,
                     const std::vector<double>& reference) {
  double off = 0, sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    off += std::abs(values[i] - reference[i]);
    sum += std::abs(reference[i]);
  }
  return off / sum;
}

double Sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

void Run(std::size_t count, double duration) {
  const std::vector<Phenotype> robots = RandomRobots(count);
  double modules = 0;
  for (const Phenotype& robot : robots)
    modules += static_cast<double>(robot.body.modules.size());
  fmt::print(
      "{} random robots with joints, {:.1f} modules on average, {} s "
      "on flat ground\n",
      count, modules / static_cast<double>(count), duration);
  fmt::print("{:<24} {:>7} {:>7} {:>9} {:>7} {:>8} {:>8} {:>7}\n",
             "solver, step", "Speed", "any way", "error", "moves", "x real",
             "cost", "failed");
  std::optional<Measured> reference;
  for (const Way& way : kWays) {
    const Measured measured = Try(robots, way, duration);
    if (!reference) reference = measured;
    fmt::print(
        "{:<24} {:>7.3f} {:>7.3f} {:>9.3f} {:>7.2f} {:>8.0f} {:>8.2f} {:>7}\n",
        way.name, RankCorrelation(measured.uphill, reference->uphill),
        RankCorrelation(measured.any, reference->any),
        RelativeError(measured.uphill, reference->uphill),
        Sum(measured.any) / Sum(reference->any),
        measured.lived / measured.seconds,
        measured.seconds / reference->seconds, measured.failed.size());
    for (const std::string& reason : measured.failed)
      fmt::print("    {}\n", reason);
    std::fflush(stdout);
  }
  fmt::print(
      "Speed, any way: rank correlations with the first line; error: "
      "sum of differences\nof Speed over sum of Speed; cost: processor "
      "time against the first line\n");
}

}  // namespace
}  // namespace plsc::bench

int main(int argc, char** argv) {
  const bool smoke = argc > 1 && std::strcmp(argv[1], "--smoke") == 0;
  const long count = smoke ? 3 : argc > 1 ? std::atol(argv[1]) : 100;
  const double duration = smoke      ? 0.2
                          : argc > 2 ? std::strtod(argv[2], nullptr)
                                     : 10;
  if (count < 2 || !(duration > 0)) {
    fmt::print(stderr, "usage: solver_bench [--smoke | ROBOTS SECONDS]\n");
    return 2;
  }
  plsc::bench::Run(static_cast<std::size_t>(count), duration);
  return 0;
}
