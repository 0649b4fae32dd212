#include "runtime/evaluation.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "tests/runtime/compile_text.h"

namespace plsc {

namespace {

using test::Robot;

/// The paper's seasons, two seconds each.
Scenario ShortScenario() {
  Scenario scenario = PaperScenario();
  for (Season& season : scenario.seasons) season.duration = 2;
  return scenario;
}

}  // namespace

TEST_CASE("The fitness of a season is Eq. 2, in m/s", "[evaluation]") {
  struct Row {
    const char* why;
    double speed;
    int hinges;
    double expected;
  };
  const std::vector<Row> rows = {
      {"forwards: the speed", 0.025, 4, 0.025},
      {"backwards: a tenth of it", -0.025, 4, -0.0025},
      {"no movement: worse than any slide", 0, 4, -0.1},
      {"no movement in the other direction", -0.0, 4, -0.1},
      {"no joint: as no movement, however it fell", 0.025, 0, -0.1},
      {"no joint, fell backwards", -0.025, 0, -0.1},
      {"one joint is enough", 1e-9, 1, 1e-9}};
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(SeasonFitness(row.speed, row.hinges) ==
            Approx(row.expected).epsilon(1e-15));
    }
  }
}

TEST_CASE("Every season is lived by the robot that develops for it",
          "[evaluation]") {
  const Genotype genotype = Robot(
      "sense inclined: bool\n"
      "iterations 1\n"
      "rule C -> if inclined = False then { C add_front A2(0.5, 4, 2, 1) "
      "move_front add_front B }\n"
      "rule C -> if inclined = True then { C add_left B add_right B }\n");
  const Scenario scenario = ShortScenario();
  const Evaluation evaluation = Evaluate(genotype, scenario);
  REQUIRE(evaluation.seasons.size() == 2);
  const SeasonResult& flat = evaluation.seasons[0];
  CHECK(flat.season == "flat");
  CHECK(flat.outcome == Outcome::kCompleted);
  CHECK(flat.body.hinge_count == 1);
  CHECK(flat.body.brick_count == 1);
  CHECK(flat.behaviour.is_valid);
  CHECK(flat.fitness ==
        SeasonFitness(flat.behaviour.displacement_velocity_hill, 1));
  CHECK(flat.fitness != -0.1);
  // Without joints: the fitness is known, and the life measured all the same.
  const SeasonResult& tilted = evaluation.seasons[1];
  CHECK(tilted.season == "tilted");
  CHECK(tilted.outcome == Outcome::kCompleted);
  CHECK(tilted.body.hinge_count == 0);
  CHECK(tilted.body.brick_count == 2);
  CHECK(tilted.behaviour.is_valid);
  CHECK(tilted.behaviour.head_balance < 1);
  CHECK(tilted.fitness == -0.1);
}

TEST_CASE("A season's life is what the evaluation has of it", "[evaluation]") {
  const Genotype genotype = Robot(
      "rule C -> { C add_front A2(0.5, 4, 2, 1) move_front add_front B }\n");
  const Scenario scenario = ShortScenario();
  const SeasonLife life = LiveSeason(genotype, scenario, scenario.seasons[1]);
  const SeasonResult evaluated = Evaluate(genotype, scenario).seasons[1];
  CHECK(life.trajectory.time(life.trajectory.time.size() - 1) ==
        Approx(2).margin(0.005));
  CHECK(life.result.state_hash == life.trajectory.state_hash);
  CHECK(evaluated.state_hash == life.result.state_hash);
  CHECK(evaluated.fitness == life.result.fitness);
}

TEST_CASE("The seasons' settings reach the simulation", "[evaluation]") {
  const Genotype genotype = Robot(
      "rule C -> { C add_front A2(0.5, 4, 2, 1) move_front add_front B }\n");
  const Scenario usual = ShortScenario();
  const auto hash = [&](const Scenario& scenario) {
    return Evaluate(genotype, scenario).seasons[0].state_hash;
  };
  struct Row {
    const char* why;
    void (*change)(Scenario&);
  };
  const std::vector<Row> rows = {
      {"duration", [](Scenario& s) { s.seasons[0].duration = 1; }},
      {"height", [](Scenario& s) { s.seasons[0].start_height = 0.05; }},
      {"ground",
       [](Scenario& s) { s.seasons[0].terrain = s.seasons[1].terrain; }},
      {"physics", [](Scenario& s) { s.physics.gravity = 1.6; }},
      {"servo", [](Scenario& s) { s.servo.gain = 0.1; }}};
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      Scenario changed = usual;
      row.change(changed);
      CHECK(hash(changed) != hash(usual));
    }
  }
}

TEST_CASE("A robot that cannot live has an outcome and no fitness",
          "[evaluation]") {
  struct Row {
    const char* why;
    Genotype genotype;
    Outcome expected;
  };
  const std::vector<Row> rows = {
      {"a string beyond its limit",
       Robot("iterations 100\nrule C -> { C B B }\nrule B -> { B B }\n"),
       Outcome::kUndeveloped},
      // Two joints in line, and beside them bricks, of which the last has a
      // sensor towards them: it reaches into the second joint's servo.
      {"modules in each other",
       Robot("iterations 1\n"
             "rule C -> { C add_front B move_front "
             "add_front A2(0.5, 4, 2, 1) move_front "
             "add_front A2(0.5, 4, 2, 1) move_back "
             "add_right B move_right add_left B move_left "
             "add_front B move_front add_left T(0.5) }\n"),
       Outcome::kOverlapping}};
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      for (const SeasonResult& season :
           Evaluate(row.genotype, ShortScenario()).seasons) {
        CHECK(season.outcome == row.expected);
        CHECK_FALSE(season.fitness);
        CHECK_FALSE(season.behaviour.is_valid);
      }
    }
  }
}

}  // namespace plsc
