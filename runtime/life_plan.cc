#include "runtime/life_plan.h"

#include <cassert>
#include <numbers>
#include <utility>

#include "runtime/formats/phenotype_json.h"
#include "runtime/season_teller.h"
#include "sim/imu.h"
#include "sim/simulate.h"

namespace plsc {

namespace {

/// Everything written out that a season's simulation depends on: the scenario
/// with this season alone. Its name changes nothing, nor what robots are told,
/// which is in their phenotypes.
std::string TextOf(const Scenario& scenario, const Season& season) {
  Scenario alone = scenario;
  alone.name.clear();
  alone.seasons = {season};
  alone.seasons[0].name = "season";
  alone.seasons[0].senses.clear();
  alone.plasticity = Plasticity::kLifelong;
  alone.sensing = Sensing::kImu;
  return PrintScenario(alone);
}

bool IsContinuous(const Scenario& scenario) {
  return scenario.lives == Lives::kContinuous;
}

Key KeyOfPhenotype(const std::string& body, const std::string& brain) {
  return KeyOf(body + '\n' + brain);
}

Key KeyOfPhenotype(const std::optional<Phenotype>& robot) {
  if (!robot) return {};
  return KeyOfPhenotype(BodyJson(robot->body), BrainJson(*robot));
}

/// What could develop in the season for all that could be felt. The seasons
/// before matter only if the robot is already grown.
std::string PossibleRobots(const Genotype& genotype, const Scenario& scenario,
                           const Senses& inherited, std::size_t season) {
  std::string robots;
  // Level, and upside down: on both sides of every threshold but pi.
  for (const double inclination : {0.0, std::numbers::pi}) {
    SeasonTeller teller(genotype, scenario, inherited);
    std::optional<Phenotype> robot;
    bool asks_imu = false;
    for (std::size_t i = 0; i <= season; ++i) {
      std::optional<double> felt;
      asks_imu = teller.AsksImu();
      if (asks_imu) felt = inclination;
      robot = teller.Next(0, felt).robot;
    }
    robots += (asks_imu ? " felt " : " told ") + Hex(KeyOfPhenotype(robot));
  }
  return robots;
}

}  // namespace

LifePlanner::LifePlanner(Scenario scenario, SeasonSimulator simulate)
    : scenario_(std::move(scenario)), simulate_(std::move(simulate)) {
  assert(!simulate_ || !IsContinuous(scenario_));
  const State inclined = {"inclined", StateType::kBool, 0, 0, {}};
  for (const Season& season : scenario_.seasons) {
    season_texts_.push_back(TextOf(scenario_, season));
    std::optional<double> felt;
    if (!IsContinuous(scenario_) && IsFelt(scenario_, season, inclined))
      felt = FeltInclination(season.terrain, OptionsFor(scenario_, season),
                             scenario_.imu, {});
    inclinations_.push_back(felt);
  }
}

Key LifePlanner::KeyOfSeason(std::size_t season, bool asks_imu,
                             const Key& robot) const {
  return KeyOf(season_texts_[season] + (asks_imu ? "felt\n" : "told\n") +
               Hex(robot));
}

std::vector<LifePiece> LifePlanner::PlanSeasons(const Genotype& genotype,
                                                const Senses& inherited) const {
  std::vector<LifePiece> pieces;
  SeasonTeller teller(genotype, scenario_, inherited);
  for (std::size_t i = 0; !teller.is_over(); ++i) {
    const bool asks_imu = teller.AsksImu();
    const Told told =
        teller.Next(0, asks_imu ? inclinations_[i] : std::nullopt);
    if (told.robot)
      pieces.push_back(
          {i, {KeyOfSeason(i, asks_imu, KeyOfPhenotype(told.robot))}});
  }
  return pieces;
}

// Where a robot is when a season begins is known only when it has lived until
// then, and so is what it feels there.
std::vector<LifePiece> LifePlanner::PlanWhole(const Genotype& genotype,
                                              const Senses& inherited) const {
  std::string text = PrintScenario(scenario_);
  for (std::size_t i = 0; i < scenario_.seasons.size(); ++i)
    text += PossibleRobots(genotype, scenario_, inherited, i);
  LifePiece piece;
  for (std::size_t i = 0; i < scenario_.seasons.size(); ++i)
    piece.keys.push_back(KeyOf(text + std::to_string(i)));
  return {piece};
}

std::vector<LifePiece> LifePlanner::Plan(const Genotype& genotype,
                                         const Senses& inherited) const {
  return IsContinuous(scenario_) ? PlanWhole(genotype, inherited)
                                 : PlanSeasons(genotype, inherited);
}

std::vector<Simulated> LifePlanner::Simulate(const Genotype& genotype,
                                             const Senses& inherited,
                                             const LifePiece& piece) const {
  std::vector<Simulated> simulated;
  if (IsContinuous(scenario_)) {
    for (Life life(genotype, scenario_, nullptr, inherited); !life.is_over();)
      simulated.push_back(SimulatedOf(life.Next().result));
    return simulated;
  }
  SeasonTeller teller(genotype, scenario_, inherited);
  Told told;
  for (std::size_t i = 0; i <= piece.first; ++i)
    told = teller.Next(0, teller.AsksImu() ? inclinations_[i] : std::nullopt);
  assert(told.robot);
  const Season& season = scenario_.seasons[piece.first];
  Simulated one =
      simulate_ ? simulate_(*told.robot, season)
                : Judge(plsc::Simulate(*told.robot, season.terrain,
                                       OptionsFor(scenario_, season)),
                        scenario_.measured, told.result.body.absolute_size);
  one.inclination = told.result.inclination;
  return {one};
}

bool LifePlanner::IsTold(const Simulated& simulated) const {
  if (simulated.outcome == Outcome::kNotReached) return false;
  // Where a continuous life stood is known from its simulation alone.
  return simulated.outcome != Outcome::kWorkerDied || !IsContinuous(scenario_);
}

JudgedLife LifePlanner::Assemble(
    const Genotype& genotype, const Senses& inherited,
    const std::vector<std::optional<Simulated>>& simulated) const {
  assert(simulated.size() == scenario_.seasons.size());
  JudgedLife life;
  SeasonTeller teller(genotype, scenario_, inherited);
  std::vector<LifePiece> pieces = Plan(genotype, inherited);
  for (std::size_t i = 0; i < simulated.size(); ++i) {
    SeasonEvidence evidence;
    SeasonResult result;
    if (simulated[i] && !IsTold(*simulated[i])) {
      result = teller.Skip();
      result.outcome = simulated[i]->outcome;
      result.reason = simulated[i]->reason;
    } else {
      std::optional<double> felt;
      if (teller.AsksImu())
        felt = IsContinuous(scenario_) ? simulated[i]->inclination
                                       : inclinations_[i];
      Told told = teller.Next(simulated[i] ? simulated[i]->begin : 0, felt);
      result = std::move(told.result);
      if (told.robot) {
        assert(simulated[i]);
        result = Complete(std::move(result), *simulated[i]);
        evidence.body = BodyJson(told.robot->body);
        evidence.brain = BrainJson(*told.robot);
        evidence.phenotype = KeyOfPhenotype(evidence.body, evidence.brain);
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
