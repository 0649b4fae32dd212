// How true each engine, solver and step are, and what they cost: rank
// correlations of speeds with ODE's direct solver at 1 ms, over random robots
// and over evolved ones, on flat and on tilted ground. Random genotypes of the
// evolver, developed; those without joints or that overlap are drawn again. The
// evolved ones are filed (tests/data/evolved.pls).
//
// One start is one draw: a micrometre more of clearance moves ranks by 0.01. So
// each robot lives from several starts, and means and spreads over starts are
// told; the reference's own spread among its starts is the noise of the test.
// Reports; asserts nothing.
//
//   solver_bench [--smoke | ROBOTS SECONDS STARTS]   100 robots, 10 s, 8 starts

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "compiler/compile.h"
#include "runtime/develop/develop.h"
#include "runtime/vary/initialise.h"
#include "sim/measures.h"
#include "sim/overlap.h"
#include "sim/simulate.h"
#include "tests/bench/stopwatch.h"
#include "tests/sim/terrains.h"

namespace plsc::bench {
namespace {

struct Way {
  const char* name;
  EngineKind engine;
  Solver solver;
  double step;  // s
};

using enum EngineKind;

// The first is the reference.
constexpr Way kWays[] = {
    {"ODE direct, 1 ms", kOde, Solver::kDirect, 0.001},
    {"ODE direct, 2.5 ms", kOde, Solver::kDirect, 0.0025},
    {"ODE direct, 5 ms (paper)", kOde, Solver::kDirect, 0.005},
    {"ODE direct, 10 ms", kOde, Solver::kDirect, 0.010},
    {"ODE iterative 50, 5 ms", kOde, Solver::kIterative, 0.005},
    {"articulated, 1 ms", kArticulated, Solver::kDirect, 0.001},
    {"articulated, 5 ms (swift)", kArticulated, Solver::kDirect, 0.005},
    {"articulated, 10 ms", kArticulated, Solver::kDirect, 0.010},
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

/// Those in tests/data/evolved.pls, grown for flat or for inclined ground; but
/// for those that have no joints there or overlap.
std::vector<Phenotype> EvolvedRobots(bool is_inclined) {
  const std::string path = PLSC_SOURCE_DIR "/tests/data/evolved.pls";
  std::ifstream file(path);
  const Source source(path, {std::istreambuf_iterator(file), {}});
  const Result<std::vector<Program>> programs = CompileAll(source);
  if (!programs) throw std::runtime_error("cannot compile " + path);
  std::vector<Phenotype> robots;
  for (const Program& program : *programs) {
    const Genotype& genotype = program.genotype;
    const std::optional<Phenotype> robot = Develop(
        genotype,
        Environment{std::vector<double>(genotype.states.size(), is_inclined)});
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
  double lived = 0;  ///< s
  int failed = 0, warnings = 0;
};

/// Micrometres of clearance that a start has more.
double Raised(int start) {
  return start / 8.0;
}

Measured Try(const std::vector<Phenotype>& robots, const Way& way,
             const Terrain& terrain, double duration, int start) {
  Measured measured;
  SimulationOptions options;
  options.duration = duration;
  options.start_height.reset();
  options.start_clearance += 1e-6 * Raised(start);
  options.controller = ControllerMode::kCoupled;
  options.physics.engine = way.engine;
  options.physics.solver = way.solver;
  options.physics.step = way.step;
  for (const Phenotype& robot : robots) {
    const double begin = CpuSeconds();
    const Trajectory life = Simulate(robot, terrain, options);
    measured.seconds += CpuSeconds() - begin;
    measured.lived += static_cast<double>(life.steps) * way.step;
    const Behaviour behaviour = Measure(life, 1, MeasuredPoint::kMassCentre);
    if (!behaviour.is_valid) ++measured.failed;
    measured.warnings += life.solver_warnings;
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

/// What is told of one way, a number a start.
struct Figures {
  std::vector<double> speed, any, error, moves;
  double seconds = 0, lived = 0;
  int failed = 0, warnings = 0;
};

/// Mean over starts and, if there are several, half of least to greatest.
std::string Told(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double mean = Sum(values) / static_cast<double>(values.size());
  return fmt::format("{:.3f}+-{:.3f}", mean, (*most - *least) / 2);
}

Figures Compare(const std::vector<Phenotype>& robots, const Way& way,
                const Terrain& terrain, double duration,
                const std::vector<Measured>& references) {
  Figures figures;
  for (std::size_t i = 0; i < references.size(); ++i) {
    const int start = static_cast<int>(i);
    const Measured measured = Try(robots, way, terrain, duration, start);
    // The reference itself is held against its next start: its noise.
    const bool is_reference = &way == &kWays[0];
    const Measured& reference =
        references[is_reference ? (i + 1) % references.size() : i];
    figures.speed.push_back(RankCorrelation(measured.uphill, reference.uphill));
    figures.any.push_back(RankCorrelation(measured.any, reference.any));
    figures.error.push_back(RelativeError(measured.uphill, reference.uphill));
    figures.moves.push_back(Sum(measured.any) / Sum(reference.any));
    figures.seconds += measured.seconds;
    figures.lived += measured.lived;
    figures.failed += measured.failed;
    figures.warnings += measured.warnings;
  }
  return figures;
}

void Run(const char* name, const std::vector<Phenotype>& robots,
         const Terrain& terrain, double duration, int starts) {
  double modules = 0;
  for (const Phenotype& robot : robots)
    modules += static_cast<double>(robot.body.modules.size());
  fmt::print("{}: {} robots, {:.1f} modules on average, {} s, {} starts\n",
             name, robots.size(), modules / static_cast<double>(robots.size()),
             duration, starts);
  fmt::print("{:<26} {:>14} {:>14} {:>14} {:>14} {:>7} {:>7} {:>8}\n",
             "engine, step", "Speed", "any way", "error", "moves", "x real",
             "failed", "warnings");
  std::vector<Measured> references;
  for (int start = 0; start < starts; ++start)
    references.push_back(Try(robots, kWays[0], terrain, duration, start));
  for (const Way& way : kWays) {
    const Figures figures = Compare(robots, way, terrain, duration, references);
    fmt::print("{:<26} {:>14} {:>14} {:>14} {:>14} {:>7.0f} {:>7} {:>8}\n",
               way.name, Told(figures.speed), Told(figures.any),
               Told(figures.error), Told(figures.moves),
               figures.lived / figures.seconds, figures.failed,
               figures.warnings);
    std::fflush(stdout);
  }
  fmt::print("\n");
}

void RunAll(std::size_t count, double duration, int starts) {
  const std::vector<Phenotype> robots = RandomRobots(count);
  Run("random, flat", robots, {}, duration, starts);
  Run("random, 5 degrees", robots, test::Slope(5), duration, starts);
  const auto few = [&](std::vector<Phenotype> evolved) {
    if (evolved.size() > count) evolved.resize(count);
    return evolved;
  };
  Run("evolved, flat", few(EvolvedRobots(false)), {}, duration, starts);
  Run("evolved, 5 degrees", few(EvolvedRobots(true)), test::Slope(5), duration,
      starts);
  fmt::print(
      "Speed, any way: rank correlations with ODE at 1 ms from the same start, "
      "mean and half\nspread over starts (its own line: with its next start); "
      "error: sum of differences of\nSpeed over sum of Speed; moves: sum of "
      "displacements over its\n");
}

}  // namespace
}  // namespace plsc::bench

int main(int argc, char** argv) {
  const bool smoke = argc > 1 && std::strcmp(argv[1], "--smoke") == 0;
  const long count = smoke ? 3 : argc > 1 ? std::atol(argv[1]) : 100;
  const double duration = smoke      ? 0.2
                          : argc > 2 ? std::strtod(argv[2], nullptr)
                                     : 10;
  const int starts = smoke ? 1 : argc > 3 ? std::atoi(argv[3]) : 8;
  if (count < 2 || !(duration > 0) || starts < 1) {
    fmt::print(stderr,
               "usage: solver_bench [--smoke | ROBOTS SECONDS STARTS]\n");
    return 2;
  }
  plsc::bench::RunAll(static_cast<std::size_t>(count), duration, starts);
  return 0;
}
