#include "sim/measures.h"
#include "sim/trajectory.h"

#include <catch2/catch.hpp>
#include <cmath>

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
