#include "runtime/report/experiment_difference.h"

#include <catch2/catch.hpp>
#include <numbers>

namespace plsc {
namespace {

using Value = std::optional<std::string>;

TEST_CASE("The paper's experiment differs in nothing", "[report]") {
  Experiment named;
  named.name = "other";
  named.seed = 7;
  named.robots = "r";
  CHECK(DifferencesOf({Experiment{}, named}).empty());
  CHECK(DifferencesOf({}).empty());
}

TEST_CASE("What all share and the paper has not is told", "[report]") {
  Experiment one;
  one.population = 20;
  one.scenario.servo.gain = 3;
  const auto differences = DifferencesOf({one, one});
  REQUIRE(differences.size() == 2);
  CHECK(differences[0].key == "population");
  CHECK(differences[0].paper == "100");
  CHECK(differences[0].values == std::vector<Value>{"20", "20"});
  CHECK_FALSE(differences[0].is_between);
  CHECK(differences[1].key == "scenario.servo.gain");
  CHECK(differences[1].values[0] == "3 1/s");
}

TEST_CASE("The habits of a profile at the top differ from the paper's",
          "[report]") {
  const auto published = ParseExperiment(Source("e", "profile: published\n"));
  REQUIRE(published);
  const auto differences = DifferencesOf({*published});
  REQUIRE(differences.size() > 3);
  CHECK(differences[0].key == "insertion");
  CHECK(differences[0].values == std::vector<Value>{"before_end"});
  CHECK(differences[1].key == "removal");
  CHECK(differences[2].key == "inheritance");
  CHECK(differences[2].paper == "genotype");
}

TEST_CASE("Seasons are compared by their names", "[report]") {
  Experiment slow;
  slow.scenario.seasons[1].duration = 10;
  Experiment still;
  still.scenario.seasons.resize(1);
  const auto differences = DifferencesOf({slow, still});
  REQUIRE(differences.size() == 4);
  CHECK(differences[0].key == "scenario.seasons.tilted.terrain");
  CHECK(differences[0].values == std::vector<Value>{"{tilted: 5 deg}", {}});
  CHECK(differences[1].key == "scenario.seasons.tilted.duration");
  CHECK(differences[1].paper == "50 s");
  CHECK(differences[1].values == std::vector<Value>{"10 s", {}});
  CHECK(differences[1].is_between);
}

}  // namespace
}  // namespace plsc
