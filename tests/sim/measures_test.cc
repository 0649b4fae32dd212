#include "sim/measures.h"
#include "sim/recorder.h"
#include "sim/trajectory.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <utility>

namespace plsc {
namespace {

constexpr double kDegree = M_PI / 180;

/// The core through three places in 4 s.
Trajectory Walk() {
  Trajectory walk;
  walk.time = Eigen::Vector3d(0, 2, 4);
  walk.core_position.resize(3, 3);
  walk.core_position.col(0) << 1, 1, 0.1;
  walk.core_position.col(1) << 4, 5, 0.0;
  walk.core_position.col(2) << 4, -1, 0.2;
  walk.core_orientation = Eigen::Matrix3Xd::Zero(3, 3);
  walk.contacts.resize(3);
  walk.contacts << 0, 4, 8;
  return walk;
}

TEST_CASE("Speeds are the core's, seen from above", "[measures]") {
  const Behaviour behaviour = Measure(Walk(), 2, MeasuredPoint::kCore);
  CHECK(behaviour.is_valid);
  CHECK(behaviour.displacement_velocity_hill == Approx(-2.0 / 4));
  CHECK(behaviour.displacement_velocity == Approx(std::sqrt(13.0) / 4));
  CHECK(behaviour.velocity == Approx((5.0 + 6.0) / 4));
}

TEST_CASE("Speeds may be those of the mass centre", "[measures]") {
  Trajectory walk = Walk();
  walk.mass_centre = walk.core_position;
  walk.mass_centre.col(1) << 1, 1, 0.5;
  walk.mass_centre.col(2) << 1, 3, 0;
  const Behaviour behaviour = Measure(walk, 2, MeasuredPoint::kMassCentre);
  CHECK(behaviour.displacement_velocity_hill == Approx(2.0 / 4));
  CHECK(behaviour.displacement_velocity == Approx(2.0 / 4));
  CHECK(behaviour.velocity == Approx(2.0 / 4));
}

TEST_CASE("Contacts are a mean over samples and modules", "[measures]") {
  CHECK(Measure(Walk(), 1, MeasuredPoint::kCore).contacts == Approx(4));
  CHECK(Measure(Walk(), 5, MeasuredPoint::kCore).contacts == Approx(0.8));
}

TEST_CASE("Balance falls with roll and pitch, whatever the yaw", "[measures]") {
  struct Row {
    const char* why;
    Eigen::Vector3d degrees;
    double balance;
  };
  const Row rows[] = {
      {"upright", {0, 0, 0}, 1},
      {"turned only", {0, 0, 120}, 1},
      {"on its side", {90, 0, 0}, 0.75},
      {"to the other side", {-90, 0, 0}, 0.75},
      {"on its back", {180, 0, 10}, 0.5},
      {"the least", {180, -90, 0}, 0.25},
      {"a bit of each", {36, -18, 0}, 0.85},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    Trajectory walk = Walk();
    walk.core_orientation = (row.degrees * kDegree).replicate(1, 3);
    CHECK(Measure(walk, 1, MeasuredPoint::kCore).head_balance ==
          Approx(row.balance));
  }
}

/// A life of `turns` of a core whose pose is a function of its turn, in rad,
/// sampled twenty times a turn.
template <typename Pose>
Trajectory Turning(double turns, const Pose& pose) {
  const auto samples = static_cast<Eigen::Index>(20 * turns) + 1;
  Trajectory life;
  life.time = Eigen::VectorXd::LinSpaced(samples, 0, 0.2 * 20 * turns);
  life.core_position.resize(3, samples);
  life.core_orientation.resize(3, samples);
  life.contacts = Eigen::VectorXi::Zero(samples);
  for (Eigen::Index i = 0; i < samples; ++i) {
    const double turn = 2 * M_PI * static_cast<double>(i) / 20;
    const auto [place, axes] = pose(turn);
    life.core_position.col(i) = place;
    life.core_orientation.col(i) = RollPitchYaw(axes);
  }
  return life;
}

using Placed = std::pair<Eigen::Vector3d, Eigen::Matrix3d>;

Eigen::Matrix3d About(const Eigen::Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

double CoreTurns(const Trajectory& life) {
  return Measure(life, 1, MeasuredPoint::kCore).core_turns;
}

TEST_CASE("A wheel turns by its girth, whichever way it goes", "[measures]") {
  constexpr double kRadius = 0.05;  // m
  const double expected = 1 / (2 * M_PI * kRadius);
  struct Row {
    const char* why;
    Eigen::Matrix3d hub;  // what is fixed in the wheel
    double heading;       // rad
  };
  const Row rows[] = {
      {"ahead", Eigen::Matrix3d::Identity(), 0},
      {"aslant", Eigen::Matrix3d::Identity(), 0.7},
      {"an axis of the core's that is no side of it", About({1, 2, 3}, 1.1),
       0.7},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    const Eigen::Vector3d ahead(std::cos(row.heading), std::sin(row.heading),
                                0);
    const Eigen::Vector3d axis = Eigen::Vector3d::UnitZ().cross(ahead);
    const Trajectory life = Turning(5, [&](double turn) {
      return Placed{kRadius * turn * ahead, About(axis, turn) * row.hub};
    });
    CHECK(CoreTurns(life) == Approx(expected));
  }
  // Round a curve of 0.5 m it leans and yaws, too.
  const Trajectory curve = Turning(8, [&](double turn) {
    const double yaw = kRadius * turn / 0.5;
    return Placed{0.5 * Eigen::Vector3d(std::sin(yaw), -std::cos(yaw), 0),
                  About({0, 0, 1}, yaw) * About({0, 1, 0}, turn)};
  });
  CHECK(CoreTurns(curve) == Approx(expected).epsilon(0.03));
}

TEST_CASE("To slide, to rock and to turn on the spot is not to roll",
          "[measures]") {
  const Eigen::Vector3d ahead(0, 0.02, 0);  // m a rad
  struct Row {
    const char* why;
    std::function<Placed(double)> pose;
    double most;  // 1/m
  };
  const Row rows[] = {
      {"slides on its side",
       [&](double turn) {
         return Placed{turn * ahead, About({1, 0, 0}, M_PI / 2)};
       },
       1e-9},
      {"rocks by 30 degrees as it rows",
       [&](double turn) {
         return Placed{turn * ahead, About({1, 0, 0}, 0.5 * std::sin(turn))};
       },
       1e-9},
      {"rocks as it turns about",
       [&](double turn) {
         return Placed{turn * ahead,
                       About({0, 0, 1}, turn / 4) *
                           About({1, 0, 0}, 0.5 * std::sin(turn))};
       },
       0.02},
      {"spins upright",
       [&](double turn) {
         return Placed{turn * ahead, About({0, 0, 1}, turn)};
       },
       1e-9},
      {"spins on its side",
       [&](double turn) {
         return Placed{turn * ahead,
                       About({0, 0, 1}, turn) * About({0, 1, 0}, M_PI / 2)};
       },
       1e-9},
      {"spins on a slope of 5 degrees",
       [&](double turn) {
         return Placed{turn * ahead,
                       About({1, 0, 0}, M_PI / 36) * About({0, 0, 1}, turn)};
       },
       0.0077 / 2 / M_PI / 0.02},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    CHECK(CoreTurns(Turning(8, row.pose)) <= row.most);
  }
}

TEST_CASE("Who falls over where it stands has turned a quarter on 0.1 m",
          "[measures]") {
  const Trajectory life = Turning(1, [&](double turn) {
    return Placed{Eigen::Vector3d::Zero(),
                  About({1, 0, 0}, std::min(turn, M_PI / 2))};
  });
  CHECK(CoreTurns(life) == Approx(0.25 / 0.1));
}

TEST_CASE("The end of a life is measured where it is", "[measures]") {
  Trajectory walk = Walk();
  walk.core_orientation.row(2) << 3, -3, -2.5;  // rad, yaw
  const Behaviour end = Measure(walk, 2, MeasuredPoint::kCore);
  CHECK(end.final_x == 4);
  CHECK(end.final_y == -1);
  CHECK(end.final_z == 0.2);
  CHECK(end.heading == -2.5);
  CHECK(end.straightness == Approx(std::sqrt(13.0) / 11));
  // The short way across pi, then back.
  CHECK(end.turning == Approx(2 * M_PI - 6 + 0.5));
  CHECK(std::isnan(end.target_distance));
  const Behaviour near =
      Measure(walk, 2, MeasuredPoint::kCore, {{100, 0}, {4, 2}, {1, 3}});
  CHECK(near.target_distance == Approx(3));
}

TEST_CASE("Transport costs energy over weight and way", "[measures]") {
  Trajectory walk = Walk();
  walk.energy = 6;
  walk.weight = 2;
  const Behaviour far = Measure(walk, 2, MeasuredPoint::kCore);
  CHECK(far.energy == 6);
  CHECK(far.cost_of_transport == Approx(6 / (2 * std::sqrt(13.0))));
  // Who comes nowhere: as if it were a robot's length.
  walk.core_position.col(2) = walk.core_position.col(0);
  CHECK(Measure(walk, 2, MeasuredPoint::kCore).cost_of_transport ==
        Approx(6 / (2 * 0.1)));
  walk.weight = 0;
  CHECK(Measure(walk, 2, MeasuredPoint::kCore).cost_of_transport == 0);
  walk.core_position.col(1) = walk.core_position.col(0);
  CHECK(Measure(walk, 2, MeasuredPoint::kCore).straightness == 0);
}

TEST_CASE("Errors of servos are the life's", "[measures]") {
  Trajectory walk = Walk();
  walk.servo_error_median = 0.25;
  walk.servo_error_worst = 1.5;
  const Behaviour behaviour = Measure(walk, 1, MeasuredPoint::kCore);
  CHECK(behaviour.servo_error_median == 0.25);
  CHECK(behaviour.servo_error_worst == 1.5);
}

TEST_CASE("A life that was not completed has no behaviour", "[measures]") {
  for (const Outcome outcome :
       {Outcome::kOverlapping, Outcome::kUndeveloped, Outcome::kUnstable}) {
    Trajectory walk = Walk();
    walk.outcome = outcome;
    const Behaviour behaviour = Measure(walk, 1, MeasuredPoint::kCore);
    CHECK_FALSE(behaviour.is_valid);
    CHECK(behaviour.velocity == 0);
    CHECK(behaviour.head_balance == 0);
  }
  CHECK_FALSE(Measure(Trajectory{}, 1, MeasuredPoint::kCore).is_valid);
}

TEST_CASE("A life without length has no speed", "[measures]") {
  Trajectory instant = Walk();
  instant.time = Eigen::VectorXd::Zero(1);
  instant.core_position.conservativeResize(3, 1);
  instant.core_orientation.conservativeResize(3, 1);
  instant.contacts.conservativeResize(1);
  const Behaviour behaviour = Measure(instant, 1, MeasuredPoint::kCore);
  CHECK(behaviour.is_valid);
  CHECK(behaviour.displacement_velocity_hill == 0);
  CHECK(behaviour.velocity == 0);
  CHECK(behaviour.head_balance == 1);
}

}  // namespace
}  // namespace plsc
