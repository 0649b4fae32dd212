#include "runtime/life/season_result.h"

#include <catch2/catch.hpp>
#include <optional>
#include <vector>

namespace plsc {
namespace {

TEST_CASE("The fitness of a season is Eq. 2, in m/s", "[season_result]") {
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

TEST_CASE("A penalty is told as one, and not as a speed", "[season_result]") {
  struct Row {
    std::optional<double> fitness;
    const char* text;
    bool is_speed;
  };
  const std::vector<Row> rows = {{SeasonFitness(0.0266, 3), "2.66", true},
                                 {SeasonFitness(-0.01, 3), "-0.10", true},
                                 {SeasonFitness(0.0266, 0), "penalty", false},
                                 {SeasonFitness(0, 3), "penalty", false},
                                 {std::nullopt, "none", false}};
  for (const Row& row : rows) {
    INFO(row.text);
    CHECK(FitnessText(row.fitness) == row.text);
    CHECK(IsSpeed(row.fitness) == row.is_speed);
  }
}

TEST_CASE("An own formula's numbers have no unit", "[season_result]") {
  CHECK(FitnessText(-0.1, true) == "-0.1");
  CHECK(FitnessText(12.34567, true) == "12.35");
  CHECK(FitnessText(std::nullopt, true) == "none");
  CHECK(FitnessesText({0.0266, -0.1, std::nullopt}, false) ==
        "2.66 penalty none cm/s");
  CHECK(FitnessesText({-0.1, std::nullopt}, false) == "penalty none");
  CHECK(FitnessesText({0.0266, std::nullopt}, true) == "0.0266 none");
}

}  // namespace
}  // namespace plsc
