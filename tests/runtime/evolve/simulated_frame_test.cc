#include "runtime/evolve/simulated_frame.h"
#include "runtime/life/simulated.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

namespace plsc {

namespace {

std::vector<Simulated> Example() {
  Simulated flat;
  flat.begin = 0.1;
  flat.inclination = 0.1 + 0.2;
  flat.behaviour.is_valid = true;
  flat.behaviour.displacement_velocity_hill = std::nextafter(0.1, 1.0);
  flat.behaviour.displacement_velocity = 1.0 / 3;
  flat.behaviour.velocity = 2.0 / 3;
  flat.behaviour.head_balance = std::numeric_limits<double>::denorm_min();
  flat.behaviour.contacts = -0.0;
  flat.behaviour.servo_error_median = 1e-7;
  flat.behaviour.servo_error_worst = 1.0 / 7;
  flat.behaviour.core_turns = std::nextafter(3.0, 4.0);
  flat.behaviour.final_x = 2.0 / 11;
  flat.behaviour.final_y = 3.0 / 11;
  flat.behaviour.final_z = 4.0 / 11;
  flat.behaviour.heading = 5.0 / 11;
  flat.behaviour.straightness = 6.0 / 11;
  flat.behaviour.turning = 7.0 / 11;
  flat.behaviour.energy = 8.0 / 11;
  flat.behaviour.cost_of_transport = 9.0 / 11;
  flat.behaviour.target_distance = std::numeric_limits<double>::quiet_NaN();
  flat.state_hash = 0xFEDCBA9876543210u;
  flat.steps = 123456789012;
  flat.solver_warnings = 3;
  Simulated tilted;
  tilted.outcome = Outcome::kOverlapping;
  tilted.reason = "modules intersect";
  return {flat, tilted};
}

}  // namespace

TEST_CASE("What was simulated arrives bit for bit", "[simulated_frame]") {
  const auto arrived = UnpackSimulated(PackSimulated(Example()));
  REQUIRE(arrived);
  REQUIRE(arrived->size() == 2);
  const Simulated& flat = (*arrived)[0];
  CHECK(flat.begin == 0.1);
  CHECK(flat.inclination == 0.1 + 0.2);
  CHECK(flat.outcome == Outcome::kCompleted);
  CHECK(flat.reason.empty());
  CHECK(flat.behaviour.is_valid);
  CHECK(flat.behaviour.displacement_velocity_hill == std::nextafter(0.1, 1.0));
  CHECK(flat.behaviour.displacement_velocity == 1.0 / 3);
  CHECK(flat.behaviour.velocity == 2.0 / 3);
  CHECK(flat.behaviour.head_balance ==
        std::numeric_limits<double>::denorm_min());
  CHECK(std::signbit(flat.behaviour.contacts));
  CHECK(flat.behaviour.servo_error_median == 1e-7);
  CHECK(flat.behaviour.servo_error_worst == 1.0 / 7);
  CHECK(flat.behaviour.core_turns == std::nextafter(3.0, 4.0));
  CHECK(flat.behaviour.final_x == 2.0 / 11);
  CHECK(flat.behaviour.final_y == 3.0 / 11);
  CHECK(flat.behaviour.final_z == 4.0 / 11);
  CHECK(flat.behaviour.heading == 5.0 / 11);
  CHECK(flat.behaviour.straightness == 6.0 / 11);
  CHECK(flat.behaviour.turning == 7.0 / 11);
  CHECK(flat.behaviour.energy == 8.0 / 11);
  CHECK(flat.behaviour.cost_of_transport == 9.0 / 11);
  CHECK(std::isnan(flat.behaviour.target_distance));
  CHECK(flat.state_hash == 0xFEDCBA9876543210u);
  CHECK(flat.steps == 123456789012);
  CHECK(flat.solver_warnings == 3);
  const Simulated& tilted = (*arrived)[1];
  CHECK_FALSE(tilted.inclination);
  CHECK_FALSE(tilted.behaviour.is_valid);
  CHECK(tilted.outcome == Outcome::kOverlapping);
  CHECK(tilted.reason == "modules intersect");
  CHECK(UnpackSimulated(PackSimulated({}))->empty());
}

TEST_CASE("Bytes that are cut short, too many or of another layout are refused",
          "[simulated_frame]") {
  const std::string bytes = PackSimulated(Example());
  for (std::size_t length = 0; length < bytes.size(); ++length)
    CHECK_FALSE(UnpackSimulated(std::string_view(bytes).substr(0, length)));
  CHECK_FALSE(UnpackSimulated(bytes + "x"));
  for (const std::size_t place :
       {0u, 8u, 40u, 48u}) {      // layout, count, outcome,
    std::string changed = bytes;  // length of the reason
    changed[place] = static_cast<char>(changed[place] ^ 0x70);
    CHECK_FALSE(UnpackSimulated(changed));
  }
}

}  // namespace plsc
