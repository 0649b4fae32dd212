#include "runtime/report/robots.h"

#include <catch2/catch.hpp>

#include "runtime/develop/regulate.h"
#include "runtime/life/season_developer.h"
#include "runtime/pictures/body_svg.h"
#include "tests/runtime/store/stored_run.h"
#include "tests/runtime/study/small_study.h"

namespace plsc {
namespace {

/// A plastic run of the paper's seasons, evaluated by a look.
struct PlasticRun {
  test::Scratch scratch;
  std::string path = scratch / "run";
  RunStore store;

  PlasticRun() {
    const Study study = test::SmallStudy();
    REQUIRE(test::Execute({{0, 1}, path, ExperimentOf(study, {0, 1}), false}) ==
            RunEnd::kFinished);
    REQUIRE_FALSE(store.OpenForReading(path));
  }
};

}  // namespace

TEST_CASE("A portrait has every season, its body and its speed", "[robots]") {
  PlasticRun run;
  const int best = run.store.Status()->best;
  const auto portrait = PortraitOf(run.store, best);
  REQUIRE(portrait);
  const Individual one = *run.store.Find(best);
  CHECK(portrait->id == best);
  CHECK(portrait->name == one.genotype.name);
  CHECK(portrait->born == one.generation);
  REQUIRE(portrait->seasons.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    const SeasonPortrait& season = portrait->seasons[i];
    const SeasonResult& result = one.evaluation.seasons[i];
    CHECK(season.season == result.season);
    CHECK(season.size == result.body.absolute_size);
    CHECK(season.svg.starts_with("<svg"));
    CHECK(season.sensed == result.sensed);
    REQUIRE(season.speed.has_value() == result.behaviour.is_valid);
    if (season.speed)
      CHECK(*season.speed == result.behaviour.displacement_velocity_hill);
  }
  CHECK(PortraitOf(run.store, 100000).error().text.find("no robot 100000") !=
        std::string::npos);
}

TEST_CASE("Rules say in which seasons their clause held", "[robots]") {
  PlasticRun run;
  const std::vector<int> ids = *run.store.EvaluatedIds();
  for (const int id : ids) {
    CAPTURE(id);
    const Individual one = *run.store.Find(id);
    const Portrait portrait = *PortraitOf(run.store, id);
    REQUIRE(portrait.rules.size() == one.genotype.rules.size());
    for (std::size_t s = 0; s < 2; ++s) {
      std::vector<RuleIndex> held;
      for (std::size_t i = 0; i < portrait.rules.size(); ++i)
        if (portrait.rules[i].is_held[s])
          held.push_back(static_cast<RuleIndex>(i));
      CHECK(held == Regulate(one.genotype,
                             EnvironmentOf(one.evaluation.seasons[s].sensed,
                                           one.genotype.states))
                        .rules);
    }
    CHECK(portrait.rules[0].symbol == "C");
    CHECK(portrait.rules[0].clause.starts_with("inclined = "));
  }
}

TEST_CASE("Like rules are counted together", "[robots]") {
  std::vector<RuleCount> all;
  AddRules({{{"C", "a = True", {true, false}}, 2},
            {{"B", "a = True", {true, false}}, 1}},
           all);
  AddRules({{{"C", "a = True", {true, false}}, 3},
            {{"C", "a = True", {true, true}}, 1}},
           all);
  REQUIRE(all.size() == 3);
  CHECK(all[0].rule.symbol == "B");
  CHECK(all[1].count == 5);
  CHECK(all[2].count == 1);

  PlasticRun run;
  const std::vector<int> ids = *run.store.EvaluatedIds();
  const auto counts = CountRules(run.store, ids);
  REQUIRE(counts);
  int total = 0;
  for (const RuleCount& count : *counts) total += count.count;
  int expected = 0;
  for (const int id : ids)
    expected += static_cast<int>(run.store.Find(id)->genotype.rules.size());
  CHECK(total == expected);
  CHECK(counts->size() < static_cast<std::size_t>(expected));
}

}  // namespace plsc
