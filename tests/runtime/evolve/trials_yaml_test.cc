#include "runtime/evolve/trials_yaml.h"

#include <catch2/catch.hpp>
#include <numbers>
#include <string>

#include "runtime/evolve/experiment.h"

namespace plsc {

namespace {

std::string FirstErrorOf(const std::string& yaml) {
  const auto parsed = ParseExperiment(Source("x.yaml", yaml));
  return parsed ? "" : parsed.diagnostics().front().message;
}

}  // namespace

TEST_CASE("Trials are read and printed to equal ones", "[trials_yaml]") {
  const auto parsed = ParseExperiment(Source(
      "x.yaml",
      "trials: 5\ntrials_fitness: {quantile: 0.25}\nown_lives: True\n"
      "noise: {start_height: 30 um, place: 2 cm, yaw: 5 deg, inclination: 1 "
      "deg, touch: 0.05, motor: 2 deg, friction: 0.1}\n"));
  REQUIRE(parsed);
  const TrialOptions& options = parsed->trials;
  CHECK(options.count == 5);
  CHECK(options.quantile == 0.25);
  CHECK(options.own_lives);
  CHECK(options.noise.start_height == 30e-6);
  CHECK(options.noise.place == 0.02);
  CHECK(options.noise.yaw == Approx(std::numbers::pi / 36));
  CHECK(options.noise.touch == 0.05);
  CHECK(options.noise.friction == 0.1);
  for (const char* fitness : {"mean", "median", "min", "{quantile: 0.1}"}) {
    const auto one = ParseExperiment(
        Source("x.yaml", std::string("trials_fitness: ") + fitness + "\n"));
    REQUIRE(one);
    const auto again = ParseExperiment(Source("y.yaml", PrintExperiment(*one)));
    REQUIRE(again);
    CHECK(again->trials == one->trials);
    CHECK(PrintTrials(one->trials).find(fitness) != std::string::npos);
  }
  const auto again =
      ParseExperiment(Source("y.yaml", PrintExperiment(*parsed)));
  REQUIRE(again);
  CHECK(*again == *parsed);
  CHECK_FALSE(HasTrials(Experiment{}.trials));
}

TEST_CASE("What is wrong with trials is told", "[trials_yaml]") {
  struct Row {
    const char* yaml;
    const char* error;
  };
  const Row rows[] = {
      {"trials: 0\n", "expected a whole number of 1 to 1000"},
      {"trials: 1001\n", "expected a whole number of 1 to 1000"},
      {"trials: 99999999999999999999\n", "expected a whole number"},
      {"trials: -1\n", "expected a whole number"},
      {"trials: 2.5\n", "expected a whole number"},
      {"trials: .nan\n", "expected a whole number"},
      {"trials: [3]\n", "expected a whole number"},
      {"trials: 2\ntrials: 3\n", "'trials'"},
      {"trials: some\n", "expected a whole number"},
      {"trials: 3\n", "without noise all 3 trials of a robot are the same"},
      {"trials_fitness: best\n", "expected"},
      {"trials_fitness: {quantile: 2}\n", "expected"},
      {"trials_fitness: {quantil: 0.5}\n", "unknown key 'quantil'"},
      {"own_lives: perhaps\n", "expected"},
      {"trials_fitness: {}\n", "quantile"},
      {"trials_fitness: {quantile: .nan}\n", "expected"},
      {"trials_fitness: 0.5\n", "expected"},
      {"noise: {start_height: .nan}\n", "expected"},
      {"noise: {start_height: .inf}\n", "expected"},
      {"noise: {start_height: 1e30 m}\n", "expected"},
      {"noise: {start_height: {}}\n", "expected"},
      {"noise: [1, 2]\n", "expected noise"},
      {"noise: {friction: 10 %}\n", "expected"},
      {"noise: much\n", "expected noise"},
      {"noise: {height: 1 mm}\n", "unknown key 'height'"},
      {"noise: {start_height: 1 deg}\n", "expected a length"},
      {"noise: {start_height: -1 mm}\n", "expected"},
      {"noise: {yaw: 5}\n", "expected an angle"},
      {"noise: {touch: 0.6}\n", "expected"},
      {"noise: {friction: 1}\n", "expected"},
      {"noise: {touch: 0.1}\nprofile: published\n",
       "noise of touch sensors has no effect"},
  };
  for (const Row& row : rows) {
    INFO(row.yaml);
    CHECK_THAT(FirstErrorOf(row.yaml), Catch::Contains(row.error));
  }
  CHECK(FirstErrorOf("own_lives: True\n").empty());
}

}  // namespace plsc
