#include "runtime/cli/robots/recorded_life.h"

#include <catch2/catch.hpp>
#include <sstream>

#include "runtime/cli/files/load_program.h"
#include "runtime/cli/robots/robot_source.h"
#include "runtime/scenario/scenario_profile.h"
#include "runtime/scenario/scenario_yaml.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

struct Streams {
  std::istringstream in{test::kPlasticText};
  std::ostringstream out;
  std::ostringstream err;
  cli::Io io{in, out, err};
};

Scenario Short() {
  const auto scenario = ParseScenario(Source("s.yaml", R"(plsc_scenario: 1
seasons:
  - {name: flat, terrain: flat, duration: 1 s, senses: {inclined: False}}
  - {name: hill, terrain: {tilted: 5 deg}, duration: 1 s,
     senses: {inclined: True}}
)"));
  REQUIRE(scenario);
  return *scenario;
}

TEST_CASE("a life that is recorded is the one that is not", "[recorded_life]") {
  Streams streams;
  const auto program = cli::LoadProgram("-", false, streams.io);
  REQUIRE(program);
  const Scenario scenario = Short();
  cli::RecordedLife recorded(program->genotype, scenario, {}, true, streams.io);
  cli::RecordedLife bare(program->genotype, scenario, {}, false, streams.io);
  while (!recorded.is_over())
    CHECK(recorded.Next().result.state_hash == bare.Next().result.state_hash);
  CHECK(bare.is_over());
  REQUIRE(recorded.recording().seasons.size() == 2);
  CHECK(recorded.recording().seasons[0].name == "flat");
  CHECK(recorded.recording().seasons[1].change == Change::kBody);
  CHECK(recorded.recording().seasons[1].motion.samples() == 51);
  CHECK(recorded.recording().name == program->genotype.name);
  CHECK(bare.recording().seasons.empty());
  CHECK(streams.err.str().empty());  // no terminal, no progress
}

TEST_CASE("what cannot live is told before it should", "[recorded_life]") {
  Streams streams;
  const auto program = cli::LoadProgram("-", false, streams.io);
  REQUIRE(program);
  Scenario scenario = Short();
  CHECK(cli::CanLive(scenario, program->genotype, streams.io));
  scenario.sensing = Sensing::kGiven;
  scenario.seasons[1].senses.clear();
  CHECK(!cli::CanLive(scenario, program->genotype, streams.io));
  CHECK(streams.err.str().find("inclined") != std::string::npos);
}

}  // namespace
}  // namespace plsc
