#include "runtime/evolve/evaluation_frame.h"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

namespace plsc {

namespace {

Evaluation Example() {
  SeasonResult flat;
  flat.season = "flat";
  flat.outcome = Outcome::kCompleted;
  flat.body.absolute_size = 7;
  flat.body.proportion = 0.1 + 0.2;
  flat.brain.recurrence = 1.0 / 3;
  flat.behaviour.is_valid = true;
  flat.behaviour.head_balance = std::numeric_limits<double>::denorm_min();
  flat.behaviour.contacts = -0.0;
  flat.fitness = std::nextafter(0.1, 1.0);
  flat.state_hash = 0xFEDCBA9876543210u;
  flat.profile = Profile::kPublished;
  flat.reason = "none";
  flat.begin = 0.1;
  flat.sensed = {{"inclined", "True", true}, {"hot", "False", false}};
  flat.inclination = 0.3;
  flat.change = Change::kBody;
  flat.change_reason = "inclined False -> True";
  flat.steps = 123456789012;
  flat.solver_warnings = 3;
  SeasonResult tilted;
  tilted.season = "a season with a longer name than others";
  tilted.outcome = Outcome::kOverlapping;
  return {{flat, tilted}};
}

}  // namespace

TEST_CASE("An evaluation arrives bit for bit", "[evaluation_frame]") {
  const Evaluation sent = Example();
  const auto arrived = Unpack(Pack(sent));
  REQUIRE(arrived);
  REQUIRE(arrived->seasons.size() == 2);
  const SeasonResult& flat = arrived->seasons[0];
  CHECK(flat.season == "flat");
  CHECK(flat.outcome == Outcome::kCompleted);
  CHECK(flat.body.absolute_size == 7);
  CHECK(flat.body.proportion == 0.1 + 0.2);
  CHECK(flat.brain.recurrence == 1.0 / 3);
  CHECK(flat.behaviour.is_valid);
  CHECK(flat.behaviour.head_balance ==
        std::numeric_limits<double>::denorm_min());
  CHECK(std::signbit(flat.behaviour.contacts));
  CHECK(flat.fitness == std::nextafter(0.1, 1.0));
  CHECK(flat.state_hash == 0xFEDCBA9876543210u);
  CHECK(flat.profile == Profile::kPublished);
  CHECK(flat.reason == "none");
  CHECK(flat.begin == 0.1);
  CHECK(flat.sensed == sent.seasons[0].sensed);
  CHECK(flat.inclination == 0.3);
  CHECK(flat.change == Change::kBody);
  CHECK(flat.change_reason == "inclined False -> True");
  CHECK(flat.steps == 123456789012);
  CHECK(flat.solver_warnings == 3);
  const SeasonResult& tilted = arrived->seasons[1];
  CHECK_FALSE(tilted.inclination);
  CHECK(tilted.sensed.empty());
  CHECK(tilted.season == sent.seasons[1].season);
  CHECK(tilted.outcome == Outcome::kOverlapping);
  CHECK_FALSE(tilted.fitness);
  CHECK(Unpack(Pack({}))->seasons.empty());
}

TEST_CASE("Bytes that are cut short or too many are refused",
          "[evaluation_frame]") {
  const std::string bytes = Pack(Example());
  for (std::size_t length = 0; length < bytes.size(); length += 7)
    CHECK_FALSE(Unpack(std::string_view(bytes).substr(0, length)));
  CHECK_FALSE(Unpack(bytes + "x"));
}

}  // namespace plsc
