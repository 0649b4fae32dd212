// What a robot takes in a store, printed, not asserted: docs/runs.md and
// decision 8 have the numbers of whole runs.

#include <catch2/catch.hpp>
#include <filesystem>
#include <iostream>

#include "tests/runtime/store/stored_run.h"

namespace plsc {

TEST_CASE("A store of random robots has a size", "[store_size][slow]") {
  const test::Scratch scratch;
  Experiment experiment;
  experiment.population = 150;
  experiment.offspring = 150;
  experiment.generations = 2;
  const test::Recorder run = test::RecordRun(experiment);
  RunStore store;
  REQUIRE(store.Create(scratch / "run", experiment) == std::nullopt);
  REQUIRE(test::Report(run, store) == "");
  REQUIRE(store.Close() == std::nullopt);
  const auto size = std::filesystem::file_size(scratch / "run");
  std::cout << size / 300 << " bytes a robot, two seasons\n";
  CHECK(size > 0);
}

}  // namespace plsc
