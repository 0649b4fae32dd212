#include "runtime/scenario/scenario_fitness.h"

#include <catch2/catch.hpp>
#include <string>

#include "runtime/formula/read_formula.h"
#include "runtime/scenario/scenario_profile.h"
#include "runtime/scenario/scenario_yaml.h"

namespace plsc {
namespace {

constexpr const char* kSeasons =
    "seasons: [{terrain: flat}, {terrain: {tilted: 5 deg}}]\n";

std::string ErrorsIn(const std::string& keys) {
  const Source source("test.yaml", kSeasons + keys);
  const auto scenario = ParseScenario(source);
  return scenario ? "" : Render(scenario.diagnostics(), source, 0);
}

Scenario ScenarioOf(const std::string& keys) {
  const auto scenario = ParseScenario(Source("test.yaml", kSeasons + keys));
  REQUIRE(scenario);
  const auto again = ParseScenario(Source("printed", PrintScenario(*scenario)));
  REQUIRE(again);
  CHECK(*again == *scenario);
  return *scenario;
}

TEST_CASE("Fitness is one formula, or one a season", "[scenario_fitness]") {
  const Scenario all = ScenarioOf("fitness: speed - energy\n");
  CHECK(all.seasons[0].fitness == *ReadFormula("speed - energy"));
  CHECK(all.seasons[1].fitness == all.seasons[0].fitness);
  CHECK(DescribeFitness(all) == "speed - energy");
  const Scenario one = ScenarioOf("fitness: {tilted: energy}\n");
  CHECK_FALSE(one.seasons[0].fitness);
  CHECK(one.seasons[1].fitness == *ReadFormula("energy"));
  CHECK(DescribeFitness(one) ==
        "flat: " + std::string(kDefaultFitness) + ", tilted: energy");
  CHECK(HasOwnFitness(one));
}

TEST_CASE("The default is the same written or not", "[scenario_fitness]") {
  const Scenario plain = ScenarioOf("");
  CHECK(ScenarioOf("fitness: \"" + std::string(kDefaultFitness) + "\"\n") ==
        plain);
  CHECK_FALSE(HasOwnFitness(plain));
  CHECK(PrintFormula(DefaultFitness()) == kDefaultFitness);
  // Keys of simulations are made of this text.
  CHECK(PrintScenario(plain).find("fitness") == std::string::npos);
  CHECK(PrintScenario(plain).find("targets") == std::string::npos);
  CHECK(WithoutFitness(ScenarioOf("fitness: energy\n")) == plain);
}

TEST_CASE("Targets are places", "[scenario_fitness]") {
  const Scenario scenario = ScenarioOf(
      "targets: [{x: 1 m, y: -50 cm}, {y: 3}]\nfitness: -target_distance\n");
  CHECK(scenario.targets == std::vector<Target>{{1, -0.5}, {0, 3}});
  CHECK(PrintTargets(scenario.targets) ==
        "[{x: 1 m, y: -0.5 m}, {x: 0 m, y: 3 m}]");
}

TEST_CASE("Wrong fitness and targets are errors at their places",
          "[scenario_fitness]") {
  struct Row {
    const char* keys;
    const char* place;
    const char* message;
  };
  const Row rows[] = {
      {"fitness: sped\n", ":2:10", "no quantity is called 'sped'"},
      {"fitness: [speed]\n", ":2:10", "expected a formula"},
      {"fitness:\n", ":3:1", "expected a formula"},
      {"fitness: {flt: speed}\n", ":2:11", "did you mean 'flat'?"},
      {"fitness: {summer: speed}\n", ":2:11", "there are flat, tilted"},
      {"fitness: {flat: speed > 1}\n", ":2:17", "found True or False"},
      {"fitnes: speed\n", ":2:1", "fitness"},
      {"fitness: speed\nfitness: energy\n", ":3:1", "twice"},
      {"fitness: target_distance\n", ":2:10", "there are no targets"},
      {"fitness: target_distance\ntargets: []\n", ":2:10",
       "there are no targets"},
      {"targets: 3\n", ":2:10", "expected a list of targets"},
      {"targets: [3]\n", ":2:11", "expected a target"},
      {"targets: [{x: 3 s}]\n", ":2:15", "expected a length"},
      {"targets: [{x: 20000}]\n", ":2:15", "expected at least -10000 m"},
      {"targets: [{z: 1}]\n", ":2:12", "'z'"},
  };
  for (const Row& row : rows) {
    INFO(row.keys);
    const std::string errors = ErrorsIn(row.keys);
    INFO(errors);
    CHECK(errors.find("test.yaml" + std::string(row.place)) !=
          std::string::npos);
    CHECK(errors.find(row.message) != std::string::npos);
  }
}

}  // namespace
}  // namespace plsc
