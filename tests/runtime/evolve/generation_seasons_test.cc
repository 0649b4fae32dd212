// Simulations are shared by all who live the same, in whatever season and
// whoever they are; what each of them is told must still be its own. The other
// path is each robot alone, simulated season by season.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <vector>

#include "runtime/develop/descriptors.h"
#include "runtime/evolve/evolve.h"
#include "runtime/evolve/generation_evaluator.h"
#include "runtime/evolve/worker_request.h"
#include "runtime/life/life.h"
#include "runtime/scenario/scenario_yaml.h"
#include "tests/runtime/develop/compile_text.h"
#include "tests/runtime/evolve/fake_run.h"
#include "tests/runtime/evolve/memory_cache.h"
#include "tests/runtime/evolve/same_seasons.h"
#include "tests/runtime/workers/here.h"
#include "tests/sanitizer.h"

namespace plsc {

using test::Here;
using test::MemoryCache;
using test::PatternScenario;
using test::PatternVariants;
using test::SeasonPatterns;

namespace {

/// All that a season is, as text: every bit of every number.
std::string TextOf(const SeasonResult& season) {
  std::string text = season.season + ' ';
  text +=
      fmt::format("{} {} {} {}", OutcomeName(season.outcome), season.reason,
                  NameIn(kChangeNames, season.change), season.change_reason);
  for (const SensedState& state : season.sensed)
    text += fmt::format(" {}={} {}", state.name, state.value,
                        NameIn(kSenseSourceNames, state.from));
  const auto add = [&](const std::optional<double>& value) {
    text += value ? fmt::format(" {:a}", *value) : " none";
  };
  add(season.begin);
  add(season.inclination);
  add(season.fitness);
  for (const NamedValue& value : List(season.body)) add(value.value);
  for (const NamedValue& value : List(season.brain)) add(value.value);
  for (const NamedValue& value : List(season.behaviour)) add(value.value);
  return text + fmt::format(" {:x} {} {}", season.state_hash, season.steps,
                            season.solver_warnings);
}

std::vector<std::string> TextsOf(const Evaluation& evaluation) {
  std::vector<std::string> texts;
  for (const SeasonResult& season : evaluation.seasons)
    texts.push_back(TextOf(season));
  return texts;
}

/// A robot's seasons, lived without anybody else.
std::vector<std::string> Alone(const Individual& robot,
                               const Scenario& scenario) {
  Evaluation evaluation;
  for (Life life(robot.genotype, scenario, nullptr, robot.heritage.senses);
       !life.is_over();)
    evaluation.seasons.push_back(life.Next().result);
  return TextsOf(evaluation);
}

Individual RobotOf(int id, const std::string& text, Senses inherited = {}) {
  Individual robot;
  robot.id = id;
  robot.genotype = test::Robot(text);
  robot.heritage.senses = std::move(inherited);
  return robot;
}

constexpr const char* kOne =
    "C add_front A2(0.5, 4, 2, 1) move_front add_front B";
constexpr const char* kOther = "C add_left B add_right A1(0.5, 2, 3, 1)";

std::string Plastic(const char* state, const char* if_false,
                    const char* if_true) {
  return fmt::format(
      "sense {0}: bool\niterations 1\nrule C -> if {0} = False then {{ {1} }}\n"
      "rule C -> if {0} = True then {{ {2} }}\n",
      state, if_false, if_true);
}

/// Mirrored pairs in what is told and in what is felt, twins, heirs, one that
/// never changes and one that does not develop everywhere.
std::vector<Individual> Zoo() {
  const std::string never =
      "sense hot: bool\niterations 12\n"
      "rule C -> { C add_front B }\n"
      "rule B -> if hot = True then { B add_front B add_left B add_right B }\n";
  return {
      RobotOf(1, Plastic("hot", kOne, kOther)),
      RobotOf(2, Plastic("hot", kOther, kOne)),
      RobotOf(3, Plastic("inclined", kOne, kOther)),
      RobotOf(4, Plastic("inclined", kOther, kOne)),
      RobotOf(5, std::string("iterations 1\nrule C -> { ") + kOne + " }\n"),
      RobotOf(6, Plastic("hot", kOne, kOther)),
      RobotOf(7, Plastic("hot", kOne, kOther), {{"hot", "True"}}),
      RobotOf(8, Plastic("inclined", kOther, kOne), {{"inclined", "True"}}),
      RobotOf(9, never),
  };
}

std::vector<EvaluatedLife> EvaluateAll(const std::vector<Individual>& robots,
                                       const LifePlanner& planner,
                                       SimulationCache& cache,
                                       EvaluationCounts& counts) {
  Here workers(WorkOf(planner));
  GenerationEvaluator evaluator(planner, workers, {&cache});
  evaluator.Begin(robots);
  std::vector<EvaluatedLife> lives(robots.size());
  while (evaluator.outstanding() > 0)
    for (EvaluatedRobot& one : evaluator.Wait(0))
      lives[one.robot] = std::move(one.life);
  counts = evaluator.counts();
  return lives;
}

}  // namespace

TEST_CASE("Whatever seasons are equal, everybody gets its own life",
          "[generation_evaluator]") {
  const std::vector<Individual> robots = Zoo();
  std::size_t turn = 0;
  for (const std::vector<int>& pattern : SeasonPatterns(4))
    for (const Scenario& scenario : PatternVariants(pattern)) {
      if (!test::IsSampled(turn++)) continue;
      INFO(PrintScenario(scenario));
      const LifePlanner planner(scenario);
      MemoryCache cache;
      EvaluationCounts first, second;
      const auto lives = EvaluateAll(robots, planner, cache, first);
      const auto again = EvaluateAll(robots, planner, cache, second);
      CHECK(second.simulations == 0);
      CHECK(first.simulations + first.looked_up == second.looked_up);
      for (std::size_t i = 0; i < robots.size(); ++i) {
        CAPTURE(robots[i].id);
        const std::vector<std::string> alone = Alone(robots[i], scenario);
        CHECK(TextsOf(lives[i].evaluation) == alone);
        CHECK(TextsOf(again[i].evaluation) == alone);
      }
    }
}

// One order of work each for the two bodies; the answers come in either order.
TEST_CASE("Mirrored robots do not swap their seasons",
          "[generation_evaluator]") {
  const std::vector<Individual> robots = {
      RobotOf(1, Plastic("hot", kOne, kOther)),
      RobotOf(2, Plastic("hot", kOther, kOne))};
  const Scenario scenario = PatternScenario({0, 0});
  const LifePlanner planner(scenario);
  MemoryCache cache;
  EvaluationCounts counts;
  const auto lives = EvaluateAll(robots, planner, cache, counts);
  CHECK(counts.simulations == 2);
  CHECK(counts.looked_up == 2);
  const auto hash = [&](std::size_t robot, std::size_t season) {
    return lives[robot].evaluation.seasons[season].state_hash;
  };
  CHECK(hash(0, 0) != hash(0, 1));
  CHECK(hash(0, 0) == hash(1, 1));
  CHECK(hash(0, 1) == hash(1, 0));
  CHECK(lives[0].evidence[0].simulation == lives[1].evidence[1].simulation);
  for (std::size_t i = 0; i < 2; ++i)
    CHECK(TextsOf(lives[i].evaluation) == Alone(robots[i], scenario));
}

TEST_CASE("Runs with equal seasons show what each robot lives alone",
          "[generation_evaluator][evolve]") {
  const std::vector<std::vector<int>> patterns = SeasonPatterns(4);
  for (std::size_t turn = 0; turn < patterns.size(); turn += test::kSparser)
    for (const Encoding encoding :
         {Encoding::kPlasticoding, Encoding::kBaseline}) {
      Experiment experiment = test::SmallExperiment();
      experiment.population = 4;
      experiment.offspring = 3;
      experiment.generations = 2;
      experiment.inheritance = Inheritance::kSenses;
      experiment.genotype.encoding = encoding;
      const std::vector<Scenario> variants = PatternVariants(patterns[turn]);
      experiment.scenario = variants[turn % variants.size()];
      experiment.genotype.states = {{"inclined", StateType::kBool, 0, 0, {}},
                                    {"hot", StateType::kBool, 0, 0, {}}};
      INFO(PrintExperiment(experiment));
      test::Recorder seen;
      MemoryCache cache;
      EvolveOptions options;
      options.make_workers = [](const Work& work) {
        return std::make_unique<Here>(work);
      };
      options.caches = {&cache};
      options.observers = {&seen};
      CHECK(Evolve(experiment, options).ending == Ending::kFinished);
      REQUIRE(seen.individuals.size() == 7);
      for (const Individual& one : seen.individuals)
        CHECK(TextsOf(one.evaluation) == Alone(one, experiment.scenario));
    }
}

}  // namespace plsc
