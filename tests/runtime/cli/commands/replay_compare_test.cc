#include "runtime/cli/commands/replay_compare.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

namespace plsc {
namespace {

using Stored = std::pair<Individual, std::vector<SeasonEvidence>>;

Stored Example() {
  Individual one;
  one.id = 4;
  SeasonResult season;
  season.season = "flat";
  season.sensed = {{"inclined", "False", SenseSource::kImu}};
  season.inclination = 0.01;
  season.fitness = 0.02;
  season.behaviour.is_valid = true;
  season.behaviour.contacts = 0.0;
  season.state_hash = 5;
  one.evaluation.seasons = {season};
  SeasonEvidence evidence;
  evidence.body = "{}";
  evidence.simulation = {1, 2};
  return {one, {evidence}};
}

TEST_CASE("equal lives have no difference, whatever the sign of zero",
          "[replay_compare]") {
  const auto [stored, evidence] = Example();
  EvaluatedLife now = {stored.evaluation, evidence};
  now.evaluation.seasons[0].behaviour.contacts = -0.0;
  const cli::Replayed replayed = cli::Compare(stored, evidence, now);
  CHECK(replayed.id == 4);
  CHECK(replayed.seasons == 1);
  CHECK(replayed.values > 40);
  CHECK(replayed.differences.empty());
}

TEST_CASE("every kind of value is compared to its last bit",
          "[replay_compare]") {
  struct Row {
    const char* name;
    std::function<void(EvaluatedLife&)> change;
  };
  using Life = EvaluatedLife;
  const std::vector<Row> rows = {
      {"sensed",
       [](Life& l) { l.evaluation.seasons[0].sensed[0].value = "True"; }},
      {"inclination",
       [](Life& l) { l.evaluation.seasons[0].inclination.reset(); }},
      {"fitness",
       [](Life& l) {
         l.evaluation.seasons[0].fitness = std::nextafter(0.02, 1.0);
       }},
      {"contacts",
       [](Life& l) { l.evaluation.seasons[0].behaviour.contacts = 1e-300; }},
      {"state_hash", [](Life& l) { l.evaluation.seasons[0].state_hash = 6; }},
      {"outcome",
       [](Life& l) { l.evaluation.seasons[0].outcome = Outcome::kUnstable; }},
      {"recurrence",
       [](Life& l) { l.evaluation.seasons[0].brain.recurrence = 0.5; }},
      {"body", [](Life& l) { l.evidence[0].body = "{ }"; }},
      {"simulation",
       [](Life& l) {
         l.evidence[0].simulation = {1, 3};
       }},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const auto [stored, evidence] = Example();
    EvaluatedLife now = {stored.evaluation, evidence};
    row.change(now);
    const cli::Replayed replayed = cli::Compare(stored, evidence, now);
    REQUIRE(replayed.differences.size() == 1);
    CHECK(replayed.differences[0].name == row.name);
    CHECK(replayed.differences[0].season == "flat");
    CHECK(replayed.differences[0].stored != replayed.differences[0].now);
  }
}

}  // namespace
}  // namespace plsc
