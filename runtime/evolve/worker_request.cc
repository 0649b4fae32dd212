// Requests are text that compiles, not memory: what is simulated is then
// exactly what a store shows, and a worker may be on another machine. Printing
// and compiling take some 0.05 ms (decision 2). Answers are frames with every
// double bit for bit. The limit after which a worker hangs is twenty times what
// the largest robot of the scenario could take, so that no slow machine ever
// meets it.

#include "runtime/evolve/worker_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <string_view>
#include <utility>

#include "compiler/compile.h"
#include "compiler/limits.h"
#include "compiler/print.h"
#include "grammar/number.h"
#include "runtime/evolve/simulated_frame.h"
#include "runtime/life/simulated.h"

namespace plsc {

namespace {

/// The next line, without its end, which it takes from `text`.
std::string_view TakeLine(std::string_view& text) {
  const std::size_t end = text.find('\n');
  assert(end != std::string_view::npos);
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end + 1);
  return line;
}

std::size_t TakeNumber(std::string_view& text) {
  return ReadNumber<std::size_t>(TakeLine(text)).value;
}

/// s that the largest robot's season takes, about (sim/options.h). One of 256
/// links, the most that are simulated by default, is simulated as fast as it
/// lives: a step of 5 ms, and 50 iterations, in that time. A direct step of ODE
/// grows with the fourth power of the links: 1.3 ms for 30, 21 ms for 60. The
/// articulated engine is faster than either.
double LongestSeason(const Scenario& scenario, const Season& season) {
  constexpr double kStep = 0.005;
  constexpr double kIterations = 50;
  const PhysicsOptions& physics = season.physics;
  const double iterative =
      kStep * std::max(1.0, physics.solver_iterations / kIterations);
  const double direct_links = physics.engine == EngineKind::kArticulated
                                  ? 0
                                  : std::min({physics.max_direct_links,
                                              scenario.max_links, kMaxModules});
  const double square = direct_links / 60 * (direct_links / 60);
  const double direct = 0.021 * square * square;
  const double steps = season.duration / physics.step;
  return std::max(season.duration, steps * std::max(iterative, direct));
}

}  // namespace

// Lines: the first season, how many, how many disturbances, each on a line of
// its own, how many senses, each sense's name and value on lines of their own
// (neither has a line's end in it); then the genotype.
std::string RequestFor(const Genotype& genotype, const Senses& inherited,
                       const LifePiece& piece,
                       const Disturbances& disturbances) {
  std::string text = fmt::format("{}\n{}\n{}\n", piece.first, piece.keys.size(),
                                 disturbances.size());
  for (const Disturbance& disturbance : disturbances) {
    const std::string line = DisturbanceText(disturbance);
    text += line.empty() ? "\n" : line;
  }
  text += fmt::format("{}\n", inherited.size());
  for (const auto& [name, value] : inherited)
    text += fmt::format("{}\n{}\n", name, value);
  return text + Print(genotype);
}

Work WorkOf(LifePlanner planner) {
  return [planner = std::move(planner)](const std::string& request) {
    std::string_view rest = request;
    LifePiece piece;
    piece.first = TakeNumber(rest);
    piece.keys.resize(TakeNumber(rest));
    Disturbances disturbances(TakeNumber(rest));
    for (Disturbance& disturbance : disturbances)
      disturbance = ReadDisturbance(TakeLine(rest));
    Senses inherited;
    for (std::size_t left = TakeNumber(rest); left > 0; --left) {
      const std::string name(TakeLine(rest));
      inherited[name] = TakeLine(rest);
    }
    const Result<Program> program =
        Compile(Source("<worker>", std::string(rest)));
    // Every genotype prints as text that compiles to an equal one.
    assert(program);
    return PackSimulated(
        planner.Simulate(program->genotype, inherited, piece, disturbances));
  };
}

Work WorkFor(const std::string& experiment) {
  const Result<Experiment> parsed =
      ParseExperiment(Source("<experiment>", experiment));
  // It was printed by us.
  assert(parsed);
  return WorkOf(LifePlanner(parsed->scenario));
}

double HangSeconds(const Experiment& experiment) {
  // 20 times slower than the largest robots are leaves room for slow and
  // crowded machines, the rest for short seasons.
  constexpr double kSlower = 20;
  constexpr double kAtLeast = 300;
  double seconds = 0;
  for (const Season& season : experiment.scenario.seasons)
    seconds += LongestSeason(experiment.scenario, season);
  return kAtLeast + kSlower * seconds;
}

std::vector<Simulated> SimulatedOf(const Reply& reply, std::size_t seasons) {
  if (reply.answer) {
    std::optional<std::vector<Simulated>> simulated =
        UnpackSimulated(*reply.answer);
    if (simulated && simulated->size() == seasons) return std::move(*simulated);
  }
  Simulated died;
  died.outcome = Outcome::kWorkerDied;
  died.reason = reply.answer ? "the process that simulated it answered nonsense"
                             : fmt::format(
                                   "the process that simulated it "
                                   "died, twice: {}",
                                   reply.death);
  return std::vector<Simulated>(seasons, died);
}

}  // namespace plsc
