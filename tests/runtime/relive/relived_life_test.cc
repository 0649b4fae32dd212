#include "runtime/relive/relived_life.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "runtime/store/schema.h"

namespace plsc {
namespace {

TEST_CASE("a life that is lived again has every measure of behaviour",
          "[relive]") {
  const std::vector<std::string>& names = RelivedMeasures();
  CHECK(names.front() == "fitness");
  // Of the schema of runs that files of the first format have.
  CHECK(names.size() == BehaviourColumns(4).size() + 1);
  for (const std::string& column : BehaviourColumns(4))
    CHECK(std::count(names.begin(), names.end(), column) == 1);
  Behaviour behaviour;
  behaviour.is_valid = true;
  behaviour.displacement_velocity_hill = 0.25;
  const auto values = MeasuresOf(behaviour, 0.5);
  REQUIRE(values.size() == names.size());
  CHECK(values[0] == 0.5);
  const auto speed = static_cast<std::size_t>(
      std::find(names.begin(), names.end(), "displacement_velocity_hill") -
      names.begin());
  CHECK(values[speed] == 0.25);
}

TEST_CASE("a life that was not completed has no measures", "[relive]") {
  for (const auto& value : MeasuresOf({}, std::nullopt)) CHECK_FALSE(value);
}

TEST_CASE("a season's result is kept with what it was lived for", "[relive]") {
  SeasonResult result;
  result.outcome = Outcome::kUnstable;
  result.reason = "too fast";
  result.state_hash = 17;
  result.steps = 4;
  result.solver_warnings = 2;
  const RelivedSeason relived = RelivedOf({9, true, 1, 1}, 3, 2e-6, result);
  CHECK(relived.of == LifeOf{9, true, 1, 1});
  CHECK_FALSE(relived.of.is_swapped());
  CHECK(LifeOf{9, false, 1, 0}.is_swapped());
  CHECK(relived.n == 3);
  CHECK(relived.lift == 2e-6);
  CHECK(relived.outcome == Outcome::kUnstable);
  CHECK(relived.reason == "too fast");
  CHECK(relived.state_hash == 17);
  CHECK(relived.steps == 4);
  CHECK(relived.solver_warnings == 2);
}

}  // namespace
}  // namespace plsc
