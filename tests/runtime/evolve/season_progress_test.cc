#include "runtime/evolve/season_progress.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

namespace plsc {

namespace {

Evaluation Of(std::optional<double> flat, std::optional<double> hill) {
  Evaluation evaluation;
  evaluation.seasons.resize(2);
  evaluation.seasons[0].season = "flat";
  evaluation.seasons[0].fitness = flat;
  evaluation.seasons[1].season = "hill";
  evaluation.seasons[1].fitness = hill;
  return evaluation;
}

}  // namespace

TEST_CASE("Best and median of a season are those of its sorted fitnesses",
          "[season_progress]") {
  SeasonSummary summary;
  CHECK(summary.Summaries().empty());
  summary.Add({});
  CHECK(summary.Summaries().empty());
  std::vector<std::optional<double>> all;
  for (int i = 0; i < 40; ++i) {
    // Every fifth has none; equal ones among them.
    std::optional<double> fitness;
    if (i % 5 != 0) fitness = static_cast<double>(i * 7 % 19) - 9;
    all.push_back(fitness);
    summary.Add(Of(fitness, std::nullopt));
    std::vector<std::optional<double>> sorted = all;
    std::sort(sorted.begin(), sorted.end());
    const std::vector<SeasonProgress> told = summary.Summaries();
    REQUIRE(told.size() == 2);
    CHECK(told[0].season == "flat");
    CHECK(told[0].best == sorted.back());
    CHECK(told[0].median == sorted[(sorted.size() - 1) / 2]);
    CHECK(told[1].season == "hill");
    CHECK(told[1].best == std::nullopt);
    CHECK(told[1].median == std::nullopt);
  }
}

}  // namespace plsc
