#include "runtime/cli/running/relive.h"

#include <catch2/catch.hpp>

#include "tests/runtime/cli/tiny_run.h"

namespace plsc {
namespace {

TEST_CASE("survivors are in the order of what they dominate", "[relive]") {
  RunStore store;
  REQUIRE_FALSE(store.OpenForReading(test::FinishedRun().path()));
  const auto all = cli::SurvivorsOf(store, 1000);
  REQUIRE(all);
  CHECK(all->generation == 2);
  CHECK(all->ids.size() == 6);
  CHECK(all->ids.front() == store.Status()->best);
  const auto two = cli::SurvivorsOf(store, 2);
  REQUIRE(two);
  CHECK(two->ids == std::vector(all->ids.begin(), all->ids.begin() + 2));
}

TEST_CASE("robots that live again by the same engine live the same",
          "[relive]") {
  RunStore store;
  REQUIRE_FALSE(store.OpenForReading(test::FinishedRun().path()));
  const auto survivors = cli::SurvivorsOf(store, 3);
  REQUIRE(survivors);
  const auto check =
      cli::CheckByEngine(store, survivors->ids, EngineKind::kOde, 2);
  REQUIRE(check);
  CHECK(check->robots == 3);
  REQUIRE(check->seasons.size() == 2);
  for (const SeasonCheck& season : check->seasons)
    for (const CheckedLife& life : season.lives) CHECK(life.stored == life.now);
}

}  // namespace
}  // namespace plsc
