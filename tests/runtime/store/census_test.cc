// Censuses of stores against a count of the robots in memory, by other means.

#include "runtime/store/census.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/print.h"
#include "compiler/truth.h"
#include "runtime/life/season_developer.h"
#include "runtime/store/census_json.h"
#include "runtime/store/schema.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {
namespace {

const Individual& RobotOf(const test::Recorder& run, int id) {
  return run.individuals[static_cast<std::size_t>(id - 1)];
}

/// Founders that each robot descends from, by id - 1: parents come first.
std::vector<std::set<int>> Founders(const test::Recorder& run) {
  std::vector<std::set<int>> founders;
  for (const Individual& one : run.individuals) {
    const std::vector<int>& parents = one.heritage.parents;
    std::set<int> of;
    if (parents.empty()) of.insert(one.id);
    for (std::size_t i = 0; i < parents.size(); ++i)
      if (i == 0 || !one.heritage.from_second.empty())
        of.merge(std::set(founders[static_cast<std::size_t>(parents[i] - 1)]));
    founders.push_back(std::move(of));
  }
  return founders;
}

bool IsSilent(const Rule& rule, const Individual& one) {
  for (const SeasonResult& season : one.evaluation.seasons)
    if (season.sensed.size() == one.genotype.states.size() &&
        ClauseHolds(rule.clause,
                    EnvironmentOf(season.sensed, one.genotype.states).values))
      return false;
  return true;
}

CensusCounts CountInMemory(const test::Recorder& run,
                           const std::vector<std::set<int>>& descent,
                           const std::vector<int>& survivors) {
  CensusCounts counts;
  std::set<std::string> genotypes;
  std::set<std::vector<std::string>> robots;
  std::set<int> founders;
  for (const int id : survivors) {
    const Individual& one = RobotOf(run, id);
    Genotype nameless = one.genotype;
    nameless.name = "nobody";
    genotypes.insert(Print(nameless));
    std::set<std::string> bodies, brains;
    std::vector<std::string> all;
    for (const SeasonEvidence& season :
         run.evidence[static_cast<std::size_t>(id - 1)]) {
      bodies.insert(season.body);
      brains.insert(season.brain);
      all.push_back(season.body + season.brain);
    }
    robots.insert(all);
    founders.merge(std::set(descent[static_cast<std::size_t>(id - 1)]));
    if (bodies.size() > 1)
      ++counts.plastic_bodies;
    else if (brains.size() > 1)
      ++counts.plastic_brains;
    for (const Rule& rule : one.genotype.rules) {
      ++counts.rules;
      if (rule.clause.is_always()) continue;
      ++counts.regulated_rules;
      if (IsSilent(rule, one)) ++counts.silent_rules;
    }
  }
  counts.genotypes = static_cast<std::int64_t>(genotypes.size());
  counts.phenotypes = static_cast<std::int64_t>(robots.size());
  counts.founders = static_cast<std::int64_t>(founders.size());
  return counts;
}

std::vector<CensusCounts> ExpectedOf(const test::Recorder& run) {
  std::vector<CensusCounts> all;
  const std::vector<std::set<int>> descent = Founders(run);
  for (const GenerationRecord& record : run.generations)
    all.push_back(CountInMemory(run, descent, record.survivors));
  return all;
}

/// More and longer than StoredExperiment's, so that robots come to be related.
Experiment Kin() {
  Experiment experiment = test::StoredExperiment();
  experiment.population = 66;  // more than a word of founders
  experiment.offspring = 12;
  experiment.generations = 6;
  return experiment;
}

TEST_CASE("What is kept of each generation is its survivors' census",
          "[census]") {
  const Experiment experiment = Kin();
  const test::Recorder run = test::RecordRun(experiment);
  const std::vector<CensusCounts> expected = ExpectedOf(run);
  REQUIRE(expected.size() == 6);
  // The example has all there is to count.
  CHECK(expected.front().founders == 66);
  CHECK(expected.back().founders < 66);
  CHECK(expected.back().founders > 1);
  CHECK(expected.back().genotypes < 66);
  CHECK(expected.back().phenotypes < expected.back().genotypes);
  CHECK(expected.back().silent_rules > 0);
  CHECK(expected.back().silent_rules < expected.back().regulated_rules);
  CHECK(expected.back().plastic_bodies > 0);

  const test::Scratch scratch;
  RunStore store;
  REQUIRE(store.Create(scratch / "run", experiment) == std::nullopt);
  CHECK(test::Report(run, store).empty());
  CHECK(*store.Censuses() == expected);
  REQUIRE(store.Close() == std::nullopt);
  {
    // Whatever is remembered of clauses.
    Database database;
    REQUIRE_FALSE(database.Open(scratch / "run", Database::Mode::kRead));
    Census forgetful(database, experiment, 0);
    for (std::size_t g = 0; g < expected.size(); ++g)
      CHECK(forgetful.Count(run.generations[g].survivors) == expected[g]);
  }

  // Left within generation 4, and gone on with.
  REQUIRE(store.Create(scratch / "left", experiment) == std::nullopt);
  CHECK(test::Report(run, store, 0, 4).empty());
  REQUIRE(store.Close() == std::nullopt);
  REQUIRE(store.Open(scratch / "left") == std::nullopt);
  for (std::size_t g = 4; g < 6; ++g) {
    std::vector<Individual> born;
    for (const int id : run.births[g]) born.push_back(RobotOf(run, id));
    REQUIRE(store.OnBirths(born, {}) == std::nullopt);
    for (std::size_t i = g == 4 ? born.size() / 2 : 0; i < born.size(); ++i)
      REQUIRE(store.OnEvaluated(
                  born[i],
                  run.evidence[static_cast<std::size_t>(born[i].id - 1)]) ==
              std::nullopt);
    REQUIRE(store.OnGeneration(run.generations[g]) == std::nullopt);
  }
  CHECK(*store.Censuses() == expected);
  REQUIRE(store.Close() == std::nullopt);
}

TEST_CASE("Of an older store the census is counted when it is asked for",
          "[census]") {
  struct Row {
    const char* file;
    std::vector<CensusCounts> counts;
  };
  // Counted by hand, with sqlite3.
  const Row rows[] = {
      {"run_schema_1.sqlite",
       {{3, 3, 3, 3, 0, 30, 30, 4}, {3, 3, 2, 3, 0, 30, 30, 6}}},
      {"run_schema_2.sqlite",
       {{4, 4, 4, 3, 0, 40, 40, 6}, {4, 3, 3, 4, 0, 40, 40, 6}}},
  };
  for (const Row& row : rows) {
    INFO(row.file);
    RunStore store;
    REQUIRE(store.OpenForReading(std::string(PLSC_SOURCE_DIR "/tests/data/") +
                                 row.file) == std::nullopt);
    const auto counted = store.Censuses();
    REQUIRE(counted);
    for (const CensusCounts& one : *counted)
      UNSCOPED_INFO(CensusJson(one).dump());
    CHECK(*counted == row.counts);
  }
}

}  // namespace
}  // namespace plsc
