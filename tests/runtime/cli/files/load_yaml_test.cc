#include "runtime/cli/files/load_yaml.h"

#include <catch2/catch.hpp>
#include <sstream>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

struct Loaded {
  std::optional<Experiment> experiment;
  std::string err;
};

Loaded Load(const std::string& path) {
  std::istringstream in;
  std::ostringstream out;
  std::ostringstream err;
  cli::Io io{in, out, err};
  auto experiment = cli::LoadExperiment(path, io);
  return {std::move(experiment), err.str()};
}

TEST_CASE("an experiment finds its scenario beside itself", "[load_yaml]") {
  const test::TemporaryFolder folder;
  folder.Write("s.yaml",
               "plsc_scenario: 1\nname: mine\nseasons:\n"
               "  - {name: one, senses: {inclined: True}}\n");
  const auto loaded =
      Load(folder.Write("e.yaml", "plsc_experiment: 1\nscenario: s.yaml\n"));
  INFO(loaded.err);
  REQUIRE(loaded.experiment);
  CHECK(loaded.experiment->scenario.name == "mine");
}

TEST_CASE("a scenario's file is read by the profile of the experiment",
          "[load_yaml]") {
  const test::TemporaryFolder folder;
  folder.Write("none.yaml", "plsc_scenario: 1\nseasons: [{}]\n");
  folder.Write("own.yaml", "plsc_scenario: 1\nprofile: paper\nseasons: [{}]\n");
  for (const bool is_own : {false, true}) {
    const auto loaded = Load(
        folder.Write("e.yaml", std::string("profile: swift\nscenario: ") +
                                   (is_own ? "own.yaml\n" : "none.yaml\n")));
    INFO(loaded.err);
    REQUIRE(loaded.experiment);
    CHECK(UsesOde(loaded.experiment->scenario) == is_own);
  }
}

TEST_CASE("what is wrong around an experiment is said", "[load_yaml]") {
  const test::TemporaryFolder folder;
  folder.Write("s.yaml",
               "plsc_scenario: 1\nsensing: given\nseasons:\n"
               "  - {name: one}\n");
  const auto no_scenario =
      Load(folder.Write("a.yaml", "plsc_experiment: 1\nscenario: none.yaml\n"));
  CHECK_FALSE(no_scenario.experiment);
  CHECK(no_scenario.err.find("none.yaml") != std::string::npos);
  const auto no_sense =
      Load(folder.Write("b.yaml", "plsc_experiment: 1\nscenario: s.yaml\n"));
  CHECK_FALSE(no_sense.experiment);
  CHECK(no_sense.err.find("inclined") != std::string::npos);
  CHECK_FALSE(Load(folder / "none.yaml").experiment);
}

TEST_CASE("the example experiments and scenarios are correct", "[load_yaml]") {
  CHECK(Load(test::InRepository("examples/small.yaml")).experiment);
  CHECK(Load(test::InRepository("examples/walkers.yaml")).experiment);
  std::istringstream in;
  std::ostringstream out;
  std::ostringstream err;
  cli::Io io{in, out, err};
  const auto desert =
      cli::LoadScenario(test::InRepository("examples/desert.yaml"), io);
  INFO(err.str());
  REQUIRE(desert);
  CHECK(desert->seasons.size() == 4);
}

}  // namespace
}  // namespace plsc
