#include "runtime/life/evaluation.h"
#include "runtime/life/life.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "runtime/scenario/scenario_profile.h"
#include "tests/runtime/develop/compile_text.h"

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
  // Nobody told it: it felt the slope.
  CHECK(flat.sensed ==
        std::vector<SensedState>{{"inclined", "False", SenseSource::kImu}});
  CHECK(tilted.sensed ==
        std::vector<SensedState>{{"inclined", "True", SenseSource::kImu}});
  CHECK(*flat.inclination < 0.001);
  CHECK(*tilted.inclination == Approx(0.0873).margin(0.018));
  CHECK(flat.change == Change::kBorn);
  CHECK(flat.change_reason == "inclined=False (IMU 0.0 deg)");
  CHECK(tilted.change == Change::kBody);
  CHECK(tilted.change_reason.find("inclined False -> True (IMU ") == 0);
  CHECK(tilted.fitness == -0.1);
}

TEST_CASE("A season's life is what the evaluation has of it", "[evaluation]") {
  const Genotype genotype = Robot(
      "rule C -> { C add_front A2(0.5, 4, 2, 1) move_front add_front B }\n");
  const Scenario scenario = ShortScenario();
  Life lives(genotype, scenario);
  CHECK(lives.Next().result.season == "flat");
  const SeasonLife life = lives.Next();
  CHECK(lives.is_over());
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
      {"physics", [](Scenario& s) { s.seasons[0].physics.gravity = 1.6; }},
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
    const char* reason;
  };
  const std::vector<Row> rows = {
      {"a string beyond its limit",
       Robot("iterations 100\nrule C -> { C B B }\nrule B -> { B B }\n"),
       Outcome::kUndeveloped, "2^20 symbols"},
      // Two joints in line, and beside them bricks, of which the last has a
      // sensor towards them: it reaches into the second joint's servo.
      {"modules in each other",
       Robot("iterations 1\n"
             "rule C -> { C add_front B move_front "
             "add_front A2(0.5, 4, 2, 1) move_front "
             "add_front A2(0.5, 4, 2, 1) move_back "
             "add_right B move_right add_left B move_left "
             "add_front B move_front add_left T(0.5) }\n"),
       Outcome::kOverlapping, "intersect in the rest pose"}};
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      for (const SeasonResult& season :
           Evaluate(row.genotype, ShortScenario()).seasons) {
        CHECK(season.outcome == row.expected);
        CHECK_FALSE(season.fitness);
        CHECK_FALSE(season.behaviour.is_valid);
        CHECK(season.reason.find(row.reason) != std::string::npos);
      }
    }
  }
}

namespace {

const char* const kPlasticLife =
    "sense inclined: bool\n"
    "iterations 1\n"
    "rule C -> { C add_front A2(0.5, 4, 2, 1) move_front add_front B }\n"
    "rule C -> if inclined = True then { C move_back add_left B }\n";

}  // namespace

TEST_CASE("A season may give what the robot would feel", "[evaluation]") {
  Scenario scenario = ShortScenario();
  scenario.seasons[1].senses["inclined"] = "False";
  const SeasonResult tilted =
      Evaluate(Robot(kPlasticLife), scenario).seasons[1];
  CHECK(tilted.sensed ==
        std::vector<SensedState>{{"inclined", "False", SenseSource::kSeason}});
  CHECK_FALSE(tilted.inclination);
  CHECK(tilted.change == Change::kNone);
  CHECK(tilted.body.brick_count == 1);
}

TEST_CASE("What is felt depends on the threshold", "[evaluation]") {
  Scenario scenario = ShortScenario();
  scenario.imu.threshold = 0.2;
  const SeasonResult tilted =
      Evaluate(Robot(kPlasticLife), scenario).seasons[1];
  CHECK(tilted.sensed[0].value == "False");
  CHECK(tilted.change == Change::kNone);
  CHECK(tilted.change_reason == "senses as before");
}

TEST_CASE("In one life the robot changes where it stands", "[evaluation]") {
  Scenario scenario = ShortScenario();
  scenario.lives = Lives::kContinuous;
  Season again = scenario.seasons[0];
  again.name = "again";
  Season still = again;
  still.name = "still";
  scenario.seasons.insert(scenario.seasons.end(), {again, still});
  const Genotype genotype = Robot(kPlasticLife);
  Life life(genotype, scenario);
  std::vector<SeasonLife> lived;
  while (!life.is_over()) lived.push_back(life.Next());
  REQUIRE(lived.size() == 4);
  const std::vector<Change> changes = {Change::kBorn, Change::kBody,
                                       Change::kBody, Change::kNone};
  for (std::size_t i = 0; i < 4; ++i) {
    INFO(i);
    const auto& [result, trajectory, robot] = lived[i];
    CHECK(result.outcome == Outcome::kCompleted);
    CHECK(result.begin == Approx(2.0 * static_cast<double>(i)));
    CHECK(trajectory.time(0) == Approx(result.begin));
    CHECK(result.change == changes[i]);
    CHECK(robot.has_value());
    if (i == 0) continue;
    // Where it was, seen along the ground: slopes of 5 degrees turn it a bit.
    const auto& before = lived[i - 1].trajectory.core_position;
    const Eigen::Vector3d left = before.col(before.cols() - 1);
    const Eigen::Vector3d found = trajectory.core_position.col(0);
    CHECK((found - left).head<2>().norm() < 0.005);
  }
  // The one that kept its body kept its pose, too.
  const auto& bent = lived[2].trajectory.joint_angle;
  CHECK(lived[3].trajectory.joint_angle(0, 0) ==
        Approx(bent(0, bent.cols() - 1)).margin(1e-9));
  CHECK(std::abs(bent(0, bent.cols() - 1)) > 0.01);
  CHECK(lived[1].trajectory.joint_angle.col(0).norm() == 0);
  CHECK(Evaluate(genotype, scenario).seasons[3].state_hash ==
        lived[3].result.state_hash);
}

TEST_CASE("A life that ends is not lived on", "[evaluation]") {
  Scenario scenario = ShortScenario();
  scenario.seasons[0].physics.max_speed = 1e-3;
  const Genotype genotype = Robot(kPlasticLife);
  CHECK(Evaluate(genotype, scenario).seasons[1].outcome == Outcome::kCompleted);
  scenario.lives = Lives::kContinuous;
  const Evaluation evaluation = Evaluate(genotype, scenario);
  CHECK(evaluation.seasons[0].outcome == Outcome::kUnstable);
  CHECK(evaluation.seasons[1].outcome == Outcome::kNotReached);
  CHECK(evaluation.seasons[1].reason ==
        "the life ended in season 'flat': unstable");
  CHECK_FALSE(evaluation.seasons[1].fitness);
}

TEST_CASE("Speed is the mass centre's in the paper, the core's as published",
          "[evaluation]") {
  Scenario scenario = ShortScenario();
  const Genotype genotype = Robot(
      "rule C -> { C add_front A2(0.5, 4, 2, 1) move_front add_front B }\n");
  for (const MeasuredPoint point :
       {MeasuredPoint::kMassCentre, MeasuredPoint::kCore}) {
    scenario.measured = point;
    const SeasonLife life = Life(genotype, scenario).Next();
    const auto& places = point == MeasuredPoint::kCore
                             ? life.trajectory.core_position
                             : life.trajectory.mass_centre;
    CHECK(life.result.behaviour.displacement_velocity_hill ==
          Approx((places(1, places.cols() - 1) - places(1, 0)) / 2));
  }
}

}  // namespace plsc
