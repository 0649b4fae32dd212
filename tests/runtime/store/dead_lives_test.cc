// Lives whose workers died, in runs that are left and gone on with.

#include <signal.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <string>

#include "runtime/life/simulated.h"
#include "runtime/store/result_dump.h"
#include "runtime/store/verify.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {

namespace {

using test::Look;
using test::NumberOf;
using test::Scratch;
using test::StoredExperiment;

Simulated LookAndDie(const Phenotype& robot, const Season& season,
                     const Disturbance& /*disturbance*/) {
  if (NumberOf(robot) % 3 == 1 && season.name == "flat") raise(SIGKILL);
  return Look(robot, season);
}

bool HasDied(const Individual& robot) {
  const auto& seasons = robot.evaluation.seasons;
  return std::any_of(seasons.begin(), seasons.end(), [](const auto& season) {
    return season.outcome == Outcome::kWorkerDied;
  });
}

/// Goes on with the run in the file, or begins it, until so many more are
/// evaluated.
test::Recorder LiveOn(const std::string& path, const SeasonSimulator& simulate,
                      std::size_t evaluations = 1000) {
  RunStore store;
  REQUIRE((std::filesystem::exists(path)
               ? store.Open(path)
               : store.Create(path, StoredExperiment())) == std::nullopt);
  Expected<SavedRun, Failure> saved = store.Load();
  REQUIRE(saved);
  test::Recorder seen;
  EvolveOptions options;
  options.jobs = 1;
  options.simulate = simulate;
  options.caches = {&store};
  options.saved = *saved;
  options.observers = {&store, &seen};
  options.should_stop = [&] { return seen.evaluated.size() >= evaluations; };
  const RunResult result = Evolve(StoredExperiment(), options);
  CHECK(result.failure.empty());
  CHECK(result.evaluations ==
        saved->evaluations + static_cast<int>(seen.evaluated.size()));
  REQUIRE(store.Close() == std::nullopt);
  CHECK(Examine(path).problem == std::nullopt);
  return seen;
}

std::size_t Deaths(const test::Recorder& seen) {
  return static_cast<std::size_t>(
      std::count_if(seen.individuals.begin(), seen.individuals.end(), HasDied));
}

std::string Dump(const std::string& path) {
  Expected<std::string, Failure> dump = DumpResults(path);
  REQUIRE(dump);
  return *dump;
}

}  // namespace

TEST_CASE("Who died in the generation under way lives anew, as if never dead",
          "[run_store]") {
  const Scratch scratch;
  LiveOn(scratch / "whole.sqlite", Look);
  const std::string left = scratch / "left.sqlite";
  const test::Recorder seen = LiveOn(left, LookAndDie, 6);
  REQUIRE(seen.generations.empty());
  const std::size_t dead = Deaths(seen);
  REQUIRE(dead >= 1);
  RunStore store;
  REQUIRE(store.OpenForReading(left) == std::nullopt);
  // Until then the store says what happened.
  CHECK(store.Status()->evaluations == static_cast<int>(seen.evaluated.size()));
  const Expected<SavedRun, Failure> saved = store.Load();
  REQUIRE(saved);
  CHECK(saved->evaluated.size() == seen.evaluated.size() - dead);
  CHECK(saved->evaluations == static_cast<int>(saved->evaluated.size()));
  CHECK(store.Close() == std::nullopt);

  const test::Recorder rest = LiveOn(left, Look);
  CHECK(rest.evaluated.size() == 32 - saved->evaluated.size());
  CHECK(Deaths(rest) == 0);
  CHECK(Dump(left) == Dump(scratch / "whole.sqlite"));
}

TEST_CASE("Who kills every worker dies again, and the run is the same",
          "[run_store]") {
  const Scratch scratch;
  LiveOn(scratch / "whole.sqlite", LookAndDie);
  const std::string left = scratch / "left.sqlite";
  for (int i = 0; i < 12; ++i) LiveOn(left, LookAndDie, 4);
  LiveOn(left, LookAndDie);
  CHECK(Dump(left) == Dump(scratch / "whole.sqlite"));
}

TEST_CASE("A death that a generation was selected by stays", "[run_store]") {
  const Scratch scratch;
  const std::string left = scratch / "left.sqlite";
  const test::Recorder seen = LiveOn(left, LookAndDie, 8);
  REQUIRE(seen.generations.size() == 1);
  REQUIRE(Deaths(seen) >= 1);
  LiveOn(left, Look);
  RunStore store;
  REQUIRE(store.OpenForReading(left) == std::nullopt);
  for (int id = 1; id <= 32; ++id)
    CHECK(HasDied(*store.Find(id)) ==
          (id <= 8 &&
           HasDied(seen.individuals[static_cast<std::size_t>(id) - 1])));
  CHECK(store.Generation(0)->counts == seen.generations[0].counts);
}

}  // namespace plsc
