#include "runtime/life/life_plan.h"

#include <catch2/catch.hpp>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "runtime/life/evaluation.h"
#include "runtime/scenario/scenario_profile.h"
#include "tests/runtime/develop/compile_text.h"
#include "tests/runtime/life/disturbed.h"

namespace plsc {

using test::Changes;
using test::Everything;

namespace {

constexpr const char* kPlastic =
    "sense inclined: bool\n"
    "iterations 1\n"
    "rule C -> if inclined = False then { C add_front A2(0.5, 4, 2, 1) "
    "move_front add_front B }\n"
    "rule C -> if inclined = True then { C add_left B add_right B }\n";

Scenario Short(Lives lives) {
  Scenario scenario = PaperScenario();
  scenario.lives = lives;
  for (Season& season : scenario.seasons) season.duration = 1;
  return scenario;
}

constexpr const char* kLeaner =
    "sense inclined: bool\n"
    "iterations 1\n"
    "rule C -> if inclined = False then { C add_front A2(0.5, 4, 2, 1) "
    "move_front add_front B }\n"
    "rule C -> if inclined = True then { C add_left A2(0.5, 4, 2, 1) "
    "add_right B }\n";

/// The second season on rough ground.
Scenario Brief(Lives lives, EngineKind engine) {
  Scenario scenario = PaperScenario();
  scenario.lives = lives;
  for (Season& season : scenario.seasons) season.duration = 0.3;
  scenario.seasons[1].terrain.type = TerrainType::kRough;
  CHECK_FALSE(SetEngine(scenario, engine));
  return scenario;
}

EvaluatedLife Evaluated(const LifePlanner& planner, const Genotype& genotype,
                        const Senses& inherited = {}) {
  std::vector<std::optional<Simulated>> seasons(
      planner.scenario().seasons.size());
  for (const LifePiece& piece : planner.Plan(genotype, inherited)) {
    const auto simulated = planner.Simulate(genotype, inherited, piece);
    for (std::size_t i = 0; i < simulated.size(); ++i)
      seasons[piece.first + i] = simulated[i];
  }
  return planner.Assemble(genotype, inherited, seasons);
}

void CheckSame(const SeasonResult& one, const SeasonResult& other) {
  CAPTURE(one.season);
  CHECK(one.season == other.season);
  CHECK(one.outcome == other.outcome);
  CHECK(one.reason == other.reason);
  CHECK(one.begin == other.begin);
  CHECK(one.sensed == other.sensed);
  CHECK(one.inclination == other.inclination);
  CHECK(one.change == other.change);
  CHECK(one.change_reason == other.change_reason);
  CHECK(one.body.absolute_size == other.body.absolute_size);
  CHECK(one.body.hinge_count == other.body.hinge_count);
  CHECK(one.fitness == other.fitness);
  CHECK(one.state_hash == other.state_hash);
  CHECK(one.steps == other.steps);
}

}  // namespace

TEST_CASE("A life in pieces is the life as a whole", "[life_plan]") {
  const std::string endless =
      "iterations 12\nrule C -> { C add_front B }\n"
      "rule B -> { B add_front B add_left B add_right B }\n";
  for (const Lives lives : {Lives::kIndependent, Lives::kContinuous})
    for (const Plasticity plasticity :
         {Plasticity::kLifelong, Plasticity::kMorphogenesis})
      for (const std::string& text : {std::string(kPlastic), endless}) {
        Scenario scenario = Short(lives);
        scenario.plasticity = plasticity;
        CAPTURE(static_cast<int>(lives), static_cast<int>(plasticity), text);
        const Genotype genotype = test::Robot(text);
        const Evaluation whole = Evaluate(genotype, scenario);
        const EvaluatedLife pieces = Evaluated(LifePlanner(scenario), genotype);
        REQUIRE(pieces.evaluation.seasons.size() == 2);
        for (std::size_t i = 0; i < 2; ++i)
          CheckSame(pieces.evaluation.seasons[i], whole.seasons[i]);
      }
}

TEST_CASE("Inherited senses shape the first season of both kinds of lives",
          "[life_plan]") {
  for (const Lives lives : {Lives::kIndependent, Lives::kContinuous}) {
    const LifePlanner planner(Short(lives));
    const Genotype genotype = test::Robot(kPlastic);
    const Senses inherited = {{"inclined", "True"}};
    const EvaluatedLife heir = Evaluated(planner, genotype, inherited);
    const EvaluatedLife orphan = Evaluated(planner, genotype);
    CHECK(heir.evaluation.seasons[0].body.brick_count == 2);
    CHECK(orphan.evaluation.seasons[0].body.brick_count == 1);
    CHECK(heir.evidence[0].simulation != orphan.evidence[0].simulation);
    // On the slope both are what they feel.
    CHECK(heir.evidence[1].phenotype == orphan.evidence[1].phenotype);
    // Where seasons are lived from the start, the first one changes nothing.
    CHECK((heir.evidence[1].simulation == orphan.evidence[1].simulation) ==
          (lives == Lives::kIndependent));
  }
}

TEST_CASE("Equal robots have equal keys, whatever their genotypes",
          "[life_plan]") {
  const LifePlanner planner(Short(Lives::kIndependent));
  const Genotype one = test::Robot("rule C -> { C add_front B }\n");
  const Genotype other =
      test::Robot("rule C -> { C add_front B }\nrule T -> { B }\n");
  CHECK(planner.Plan(one, {})[0].keys == planner.Plan(other, {})[0].keys);
  // The same robot on other ground is another simulation.
  CHECK(planner.Plan(one, {})[0].keys != planner.Plan(one, {})[1].keys);
}

TEST_CASE("Whatever a simulation depends on is in its key", "[life_plan]") {
  struct Row {
    const char* why;
    std::function<void(Scenario&)> change;
    bool matters = true;
  };
  const std::vector<Row> rows = {
      {"duration", [](Scenario& s) { s.seasons[0].duration = 2; }},
      {"terrain",
       [](Scenario& s) { s.seasons[0].terrain = s.seasons[1].terrain; }},
      {"start height", [](Scenario& s) { s.seasons[0].start_height = 0.3; }},
      {"step", [](Scenario& s) { s.seasons[0].physics.step = 0.004; }},
      {"friction", [](Scenario& s) { s.seasons[0].physics.friction = 0.7; }},
      {"gravity", [](Scenario& s) { s.seasons[0].physics.gravity = 9.81; }},
      {"torque", [](Scenario& s) { s.servo.max_torque = 0.2; }},
      {"sampling", [](Scenario& s) { s.sample_interval = 0.1; }},
      {"controller",
       [](Scenario& s) { s.controller = ControllerMode::kOpenLoop; }},
      {"measured", [](Scenario& s) { s.measured = MeasuredPoint::kCore; }},
      {"limits", [](Scenario& s) { s.max_links = 3; }},
      {"lives", [](Scenario& s) { s.lives = Lives::kContinuous; }},
      {"name of the scenario", [](Scenario& s) { s.name = "other"; }, false},
      {"name of the season", [](Scenario& s) { s.seasons[0].name = "other"; },
       false},
      {"what nobody asks about",
       [](Scenario& s) { s.seasons[0].senses["smoky"] = "True"; }, false},
      {"the other season", [](Scenario& s) { s.seasons[1].duration = 7; },
       false},
  };
  const Genotype genotype = test::Robot(kPlastic);
  const auto key_of = [&](const Scenario& scenario) {
    return LifePlanner(scenario).Plan(genotype, {})[0].keys[0];
  };
  const Key before = key_of(Short(Lives::kIndependent));
  for (const Row& row : rows) {
    INFO(row.why);
    Scenario scenario = Short(Lives::kIndependent);
    row.change(scenario);
    CHECK((key_of(scenario) != before) == row.matters);
  }
}

TEST_CASE("A continuous life depends on all that may develop in it",
          "[life_plan]") {
  const LifePlanner planner(Short(Lives::kContinuous));
  const auto keys_of = [&](const std::string& slope_rule) {
    const Genotype genotype = test::Robot(
        "sense inclined: bool\niterations 1\n"
        "rule C -> if inclined = False then { C add_front B }\n"
        "rule C -> if inclined = True then { C " +
        slope_rule + " }\n");
    const std::vector<LifePiece> pieces = planner.Plan(genotype, {});
    REQUIRE(pieces.size() == 1);
    REQUIRE(pieces[0].keys.size() == 2);
    return pieces[0].keys;
  };
  CHECK(keys_of("add_left B") == keys_of("add_left B"));
  CHECK(keys_of("add_left B") != keys_of("add_right B"));
  const std::vector<Key> keys = keys_of("add_left B");
  CHECK(keys[0] != keys[1]);
}

TEST_CASE("A death is told with what is known without simulating",
          "[life_plan]") {
  Simulated died;
  died.outcome = Outcome::kWorkerDied;
  died.reason = "signal 11";
  const Genotype genotype = test::Robot(kPlastic);
  for (const Lives lives : {Lives::kIndependent, Lives::kContinuous}) {
    const EvaluatedLife life =
        LifePlanner(Short(lives)).Assemble(genotype, {}, {died, died});
    for (const SeasonResult& season : life.evaluation.seasons) {
      CHECK(season.outcome == Outcome::kWorkerDied);
      CHECK(season.reason == "signal 11");
      CHECK_FALSE(season.fitness);
      CHECK((season.body.absolute_size > 0) == (lives == Lives::kIndependent));
    }
    CHECK(life.evidence[1].simulation != Key{});
  }
}

TEST_CASE("Keys hold what a profile gives and not its name", "[life_plan]") {
  const Genotype genotype = test::Robot(kPlastic);
  for (const Lives lives : {Lives::kIndependent, Lives::kContinuous}) {
    const auto keys = [&](Scenario scenario) {
      scenario.lives = lives;
      std::set<Key> all;
      for (const LifePiece& piece : LifePlanner(scenario).Plan(genotype, {}))
        all.insert(piece.keys.begin(), piece.keys.end());
      return all;
    };
    Scenario paper = Short(lives);
    Scenario swift = BothSeasons(Profile::kSwift);
    for (Season& season : swift.seasons) season.duration = 1;
    CHECK(keys(paper) != keys(swift));
    SetEngine(paper, EngineKind::kArticulated);
    CHECK(keys(paper) == keys(swift));
  }
}

TEST_CASE("Lives that are disturbed otherwise have other keys", "[life_plan]") {
  const Genotype genotype = test::Robot(kLeaner);
  for (const Lives lives : {Lives::kIndependent, Lives::kContinuous}) {
    const LifePlanner planner(Brief(lives, EngineKind::kArticulated));
    const auto keys_of = [&](const Disturbances& disturbances) {
      std::vector<Key> keys;
      for (const LifePiece& piece : planner.Plan(genotype, {}, disturbances))
        keys.insert(keys.end(), piece.keys.begin(), piece.keys.end());
      return keys;
    };
    const std::vector<Key> plain = keys_of({});
    CHECK(keys_of({{}, {}}) == plain);
    std::set<Key> all(plain.begin(), plain.end());
    for (const auto& change : Changes()) {
      Disturbances disturbances(2);
      change(disturbances[1]);
      const std::vector<Key> keys = keys_of(disturbances);
      CHECK(all.insert(keys[1]).second);
      // Seasons that are lived from the start know nothing of each other.
      CHECK((keys[0] == plain[0]) == (lives == Lives::kIndependent));
    }
  }
}

TEST_CASE("A disturbed life in pieces is the life as a whole", "[life_plan]") {
  const Genotype genotype = test::Robot(kLeaner);
  const Disturbances disturbances = {{}, Everything()};
  for (const EngineKind engine : {EngineKind::kOde, EngineKind::kArticulated})
    for (const Lives lives : {Lives::kIndependent, Lives::kContinuous}) {
      CAPTURE(static_cast<int>(engine), static_cast<int>(lives));
      const Scenario scenario = Brief(lives, engine);
      const LifePlanner planner(scenario);
      std::vector<std::optional<Simulated>> seasons(2);
      for (const LifePiece& piece : planner.Plan(genotype, {}, disturbances)) {
        const auto simulated =
            planner.Simulate(genotype, {}, piece, disturbances);
        for (std::size_t i = 0; i < simulated.size(); ++i)
          seasons[piece.first + i] = simulated[i];
      }
      const EvaluatedLife pieces =
          planner.Assemble(genotype, {}, seasons, disturbances);
      const Evaluation whole = Evaluate(genotype, scenario, disturbances);
      const Evaluation plain = Evaluate(genotype, scenario);
      for (std::size_t i = 0; i < 2; ++i) {
        const SeasonResult& one = pieces.evaluation.seasons[i];
        const SeasonResult& other = whole.seasons[i];
        const SeasonResult& before = plain.seasons[i];
        CHECK(one.outcome == Outcome::kCompleted);
        CHECK(one.state_hash == other.state_hash);
        CHECK(one.fitness == other.fitness);
        CHECK(one.inclination == other.inclination);
        CHECK(one.sensed == other.sensed);
        CHECK((one.state_hash == before.state_hash) == (i == 0));
        CHECK((one.inclination == before.inclination) == (i == 0));
      }
    }
}

TEST_CASE("A lean that passes the threshold makes another robot",
          "[life_plan]") {
  const Genotype genotype = test::Robot(kLeaner);
  Disturbances disturbances(2);
  disturbances[0].lean = -0.05;  // felt level is felt inclined, either way
  for (const Lives lives : {Lives::kIndependent, Lives::kContinuous}) {
    const Scenario scenario = Brief(lives, EngineKind::kArticulated);
    const SeasonResult flat =
        Evaluate(genotype, scenario, disturbances).seasons[0];
    CHECK(flat.inclination == Approx(0.05));
    CHECK(flat.sensed[0].value == "True");
    CHECK(flat.body.brick_count == 1);
    CHECK(flat.body.hinge_count == 1);
  }
}

}  // namespace plsc
