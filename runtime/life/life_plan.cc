// Simulations are named by content, as in a build system: a key is a hash of
// everything that a simulation is a function of, but the program and the
// machine, which whoever keeps results keeps with them (docs/decisions/0009).
// Equal keys mean equal results, bit for bit, so a generation simulates each
// life once, a run never again what it knows, and several runs can share a
// cache.
//
// What breaks this is a key that lacks something. So the text of a key is the
// whole scenario as it prints, every constant written out, of which only that
// is removed which cannot matter: names, the other seasons of independent
// lives, what robots are told (it acts through the phenotype, which has a key
// of its own), what seasons are worth, which is made of what is kept. A
// constant that is added to scenarios is thereby in the keys; one that acts
// without being printed must be added here.
//
// Where lives are independent, a season is a piece of its own. In a continuous
// life a season begins where the one before ended, so all seasons are one
// piece, and what the robot feels there is unknown: its key has the robots of
// both answers, level and upside down.
//
// Planning develops, and assembling develops again, rather than keep thousands
// of robots while their lives are simulated: both are part of the 1.1 ms of CPU
// time that a robot costs beside some 400 ms of simulation (evolve_bench).

#include "runtime/life/life_plan.h"

#include <fmt/format.h>

#include <cassert>
#include <map>
#include <numbers>
#include <utility>

#include "runtime/develop/developed.h"
#include "runtime/develop/phenotype_json.h"
#include "runtime/life/life.h"
#include "runtime/life/season_developer.h"
#include "runtime/scenario/scenario_yaml.h"
#include "sim/imu.h"
#include "sim/results.h"
#include "sim/simulate.h"

namespace plsc {

namespace {

/// Everything written out that a season's simulation depends on: the scenario
/// with this season alone. Its name changes nothing, nor that of the profile,
/// whose values are written out, nor what robots are told, which is in their
/// phenotypes.
std::string TextOf(const Scenario& scenario, const Season& season) {
  Scenario alone = scenario;
  alone.name.clear();
  alone.profile = Profile::kPaper;
  alone.seasons = {season};
  alone.seasons[0].name = "season";
  alone.seasons[0].senses.clear();
  alone.plasticity = Plasticity::kLifelong;
  alone.sensing = Sensing::kImu;
  return PrintScenario(WithoutFitness(std::move(alone)));
}

/// The same life by other arithmetic is another simulation.
std::string ResultsText() {
  return fmt::format("results {}\n", kResults);
}

bool IsContinuous(const Scenario& scenario) {
  return scenario.lives == Lives::kContinuous;
}

Key KeyIfAny(const std::optional<Phenotype>& robot) {
  return robot ? RobotKey(*robot) : Key{};
}

/// What could develop in each season if this were felt wherever the IMU is
/// asked.
std::vector<std::string> RobotsFeeling(double inclination,
                                       const Genotype& genotype,
                                       const Scenario& scenario,
                                       const Senses& inherited) {
  std::vector<std::string> robots;
  for (SeasonDeveloper seasons(genotype, scenario, inherited);
       !seasons.is_over();) {
    const bool asks_imu = seasons.AsksImu();
    std::optional<double> felt;
    if (asks_imu) felt = inclination;
    robots.push_back((asks_imu ? " felt " : " told ") +
                     Hex(KeyIfAny(seasons.Next(0, felt).robot)));
  }
  return robots;
}

/// What could develop in the seasons for all that could be felt. The seasons
/// before matter only if the robot is already grown.
std::string PossibleRobots(const Genotype& genotype, const Scenario& scenario,
                           const Senses& inherited) {
  // Level, and upside down: on both sides of every threshold but pi.
  const auto level = RobotsFeeling(0, genotype, scenario, inherited);
  const auto turned =
      RobotsFeeling(std::numbers::pi, genotype, scenario, inherited);
  std::string robots;
  for (std::size_t i = 0; i < level.size(); ++i) robots += level[i] + turned[i];
  return robots;
}

}  // namespace

LifePlanner::LifePlanner(Scenario scenario, SeasonSimulator simulate)
    : scenario_(std::move(scenario)), simulate_(std::move(simulate)) {
  assert(!simulate_ || !IsContinuous(scenario_));
  // What a core feels is a function of the season alone, so it is found here
  // once and not for each genotype.
  const State inclined = {"inclined", StateType::kBool, 0, 0, {}};
  std::map<std::string, double> known;  // of seasons that are the same
  for (const Season& season : scenario_.seasons) {
    const std::string& text =
        season_texts_.emplace_back(TextOf(scenario_, season));
    std::optional<double> felt;
    if (!IsContinuous(scenario_) && IsFelt(scenario_, season, inclined)) {
      if (!known.contains(text))
        known[text] = FeltInclination(
            season.terrain, OptionsFor(scenario_, season), scenario_.imu, {});
      felt = known[text];
    }
    inclinations_.push_back(felt);
  }
}

Key LifePlanner::KeyOfSeason(std::size_t season, bool asks_imu,
                             const Key& robot,
                             const Disturbance& disturbance) const {
  return KeyOf(season_texts_[season] + ResultsText() +
               (asks_imu ? "felt\n" : "told\n") + Hex(robot) +
               DisturbanceText(disturbance));
}

std::optional<double> LifePlanner::FeltIn(
    std::size_t season, const Disturbances& disturbances) const {
  if (!inclinations_[season] || disturbances.empty())
    return inclinations_[season];
  const Disturbance& disturbance = disturbances[season];
  const Season& lived = scenario_.seasons[season];
  const Spot spot = FeltSpot(lived.terrain, disturbance);
  const double felt =
      spot == Spot{}
          ? *inclinations_[season]
          : FeltInclination(lived.terrain, OptionsFor(scenario_, lived),
                            scenario_.imu, spot);
  return FeltWith(disturbance, felt);
}

std::vector<LifePiece> LifePlanner::PlanSeasons(
    const Genotype& genotype, const Senses& inherited,
    const Disturbances& disturbances) const {
  std::vector<LifePiece> pieces;
  SeasonDeveloper seasons(genotype, scenario_, inherited);
  for (std::size_t i = 0; !seasons.is_over(); ++i) {
    const bool asks_imu = seasons.AsksImu();
    const DevelopedSeason developed =
        seasons.Next(0, asks_imu ? FeltIn(i, disturbances) : std::nullopt);
    if (developed.robot)
      pieces.push_back({i,
                        {KeyOfSeason(i, asks_imu, RobotKey(*developed.robot),
                                     DisturbanceIn(disturbances, i))}});
  }
  return pieces;
}

// Where a robot is when a season begins is known only when it has lived until
// then, and so is what it feels there.
std::vector<LifePiece> LifePlanner::PlanWhole(
    const Genotype& genotype, const Senses& inherited,
    const Disturbances& disturbances) const {
  Scenario nameless = WithoutFitness(scenario_);
  nameless.name.clear();
  nameless.profile = Profile::kPaper;
  std::string text = PrintScenario(nameless) + ResultsText() +
                     PossibleRobots(genotype, scenario_, inherited);
  for (std::size_t i = 0; i < disturbances.size(); ++i)
    if (disturbances[i] != Disturbance{})
      text += fmt::format("\n{} {}", i, DisturbanceText(disturbances[i]));
  LifePiece piece;
  for (std::size_t i = 0; i < scenario_.seasons.size(); ++i)
    piece.keys.push_back(KeyOf(text + std::to_string(i)));
  return {piece};
}

std::vector<LifePiece> LifePlanner::Plan(
    const Genotype& genotype, const Senses& inherited,
    const Disturbances& disturbances) const {
  assert(disturbances.empty() ||
         disturbances.size() == scenario_.seasons.size());
  return IsContinuous(scenario_)
             ? PlanWhole(genotype, inherited, disturbances)
             : PlanSeasons(genotype, inherited, disturbances);
}

std::vector<Simulated> LifePlanner::Simulate(
    const Genotype& genotype, const Senses& inherited, const LifePiece& piece,
    const Disturbances& disturbances) const {
  std::vector<Simulated> simulated;
  if (IsContinuous(scenario_)) {
    for (Life life(genotype, scenario_, nullptr, inherited, disturbances);
         !life.is_over();)
      simulated.push_back(SimulatedOf(life.Next().result));
    return simulated;
  }
  SeasonDeveloper seasons(genotype, scenario_, inherited);
  DevelopedSeason developed;
  // From the first season on: whether a robot grows anew or keeps the body of
  // its birth is known to the developer of all seasons before.
  for (std::size_t i = 0; i <= piece.first; ++i)
    developed = seasons.Next(
        0, seasons.AsksImu() ? FeltIn(i, disturbances) : std::nullopt);
  assert(developed.robot);
  const Season& season = scenario_.seasons[piece.first];
  Onset onset;
  onset.disturbance = DisturbanceIn(disturbances, piece.first);
  Simulated one =
      simulate_ ? simulate_(*developed.robot, season, onset.disturbance)
                : MeasureSeason(Live(*developed.robot, season.terrain,
                                     OptionsFor(scenario_, season), onset)
                                    .trajectory,
                                scenario_, developed.result.body.absolute_size);
  one.inclination = developed.result.inclination;
  return {one};
}

bool LifePlanner::IsDeveloped(const Simulated& simulated) const {
  if (simulated.outcome == Outcome::kNotReached) return false;
  // Where a continuous life stood is known from its simulation alone.
  return simulated.outcome != Outcome::kWorkerDied || !IsContinuous(scenario_);
}

EvaluatedLife LifePlanner::Assemble(
    const Genotype& genotype, const Senses& inherited,
    const std::vector<std::optional<Simulated>>& simulated,
    const Disturbances& disturbances) const {
  assert(simulated.size() == scenario_.seasons.size());
  EvaluatedLife life;
  SeasonDeveloper seasons(genotype, scenario_, inherited);
  std::vector<LifePiece> pieces = Plan(genotype, inherited, disturbances);
  for (std::size_t i = 0; i < simulated.size(); ++i) {
    SeasonEvidence evidence;
    SeasonResult result;
    if (simulated[i] && !IsDeveloped(*simulated[i])) {
      result = seasons.Skip();
      result.outcome = simulated[i]->outcome;
      result.reason = simulated[i]->reason;
    } else {
      std::optional<double> felt;
      if (seasons.AsksImu())
        felt = IsContinuous(scenario_) ? simulated[i]->inclination
                                       : FeltIn(i, disturbances);
      DevelopedSeason developed =
          seasons.Next(simulated[i] ? simulated[i]->begin : 0, felt);
      result = std::move(developed.result);
      if (developed.robot) {
        assert(simulated[i]);
        result =
            Complete(std::move(result), *simulated[i], scenario_.seasons[i]);
        evidence.body = BodyJson(developed.robot->body);
        evidence.brain = BrainJson(*developed.robot);
        evidence.phenotype = RobotKey(evidence.body, evidence.brain);
      }
    }
    if (simulated[i]) evidence.simulated = *simulated[i];
    life.evaluation.seasons.push_back(std::move(result));
    life.evidence.push_back(std::move(evidence));
  }
  for (const LifePiece& piece : pieces)
    for (std::size_t k = 0; k < piece.keys.size(); ++k)
      life.evidence[piece.first + k].simulation = piece.keys[k];
  return life;
}

}  // namespace plsc
