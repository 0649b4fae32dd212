#include "runtime/report/relived.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace plsc {
namespace {

// Of RelivedMeasures: the fitness, which these lives have alone.
constexpr std::size_t kFitness = 0;

RelivedSeason LifeWith(const LifeOf& of, int n, std::optional<double> fitness) {
  RelivedSeason life;
  life.of = of;
  life.n = n;
  life.fitness = fitness;
  return life;
}

/// Lives 1, 2, ... of a robot as it is in season 0.
void AddLives(int id, const std::vector<std::optional<double>>& values,
              std::vector<RelivedSeason>& lives) {
  for (std::size_t i = 0; i < values.size(); ++i)
    lives.push_back(LifeWith({id}, static_cast<int>(i) + 1, values[i]));
}

RelivedGeneration Summary(std::vector<RelivedSeason> lives,
                          std::size_t seasons = 1) {
  return SummariseRelived({4, 9, {1, 2}}, seasons,
                          RelivedLives(std::move(lives)));
}

TEST_CASE("a robot counts with the median of its lives", "[relived]") {
  std::vector<RelivedSeason> lives;
  AddLives(1, {5, 1, 3}, lives);
  AddLives(2, {10, 30, 20}, lives);
  AddLives(9, {7, 8, 9}, lives);  // the best, which did not survive
  const RelivedGeneration summary = Summary(lives);
  CHECK(summary.generation == 4);
  CHECK(summary.best == 9);
  CHECK(summary.survivors == 2);
  CHECK(summary.lives == 3);
  const RelivedMeasure& fitness = summary.of(kFitness, 0);
  CHECK(fitness.mean == (3 + 20) / 2.0);
  CHECK(fitness.medians.median == 11.5);
  CHECK(fitness.best.lives == 3);
  CHECK(fitness.best.quartiles.low == 7.5);
  CHECK(fitness.best.quartiles.median == 8);
  CHECK(fitness.best.quartiles.high == 8.5);
  REQUIRE(summary.robots.size() == 2);
  CHECK(summary.robots[1].values[kFitness].quartiles.median == 20);
  CHECK(std::isnan(fitness.best_by_other.quartiles.median));
  CHECK(fitness.swapped == 0);
}

TEST_CASE("only lives that all have lived count", "[relived]") {
  std::vector<RelivedSeason> lives;
  AddLives(1, {1, 2, 3}, lives);
  AddLives(9, {1, 2}, lives);
  // Life 2 is still under way while life 3 is there.
  lives.push_back(LifeWith({2}, 3, 100));
  lives.push_back(LifeWith({2}, 1, 4));
  const RelivedGeneration summary = Summary(lives);
  CHECK(summary.lives == 1);
  CHECK(summary.of(kFitness, 0).mean == 2.5);
  lives.push_back(LifeWith({2}, 2, 8));
  CHECK(Summary(lives).lives == 2);
  CHECK(Summary(lives).of(kFitness, 0).mean == (1.5 + 6) / 2);
}

TEST_CASE("a generation that nobody of lived again has no values",
          "[relived]") {
  std::vector<RelivedSeason> lives;
  AddLives(1, {1, 2}, lives);
  const RelivedGeneration summary = Summary(lives);
  CHECK(summary.lives == 0);
  CHECK(std::isnan(summary.of(kFitness, 0).mean));
}

TEST_CASE("lives that were not completed are left out, and told", "[relived]") {
  std::vector<RelivedSeason> lives;
  AddLives(1, {std::nullopt, 2, 4}, lives);
  AddLives(2, {std::nullopt, std::nullopt, std::nullopt}, lives);
  AddLives(9, {1, 1, 1}, lives);
  const RelivedGeneration summary = Summary(lives);
  CHECK(summary.lives == 3);
  CHECK(summary.of(kFitness, 0).mean == 3);  // of robot 1 alone
  CHECK(summary.robots[0].values[kFitness].lives == 2);
  CHECK(summary.robots[1].values[kFitness].lives == 0);
}

TEST_CASE("what plastic robots lose is that of their medians", "[relived]") {
  std::vector<RelivedSeason> lives;
  for (const int id : {1, 2, 9})
    for (int n = 1; n <= 3; ++n) {
      lives.push_back(LifeWith({id, false, 0, 0}, n, 10.0 * id + n));
      lives.push_back(LifeWith({id, false, 1, 1}, n, 5));
    }
  // Robot 1 alone is plastic: 12 as it is in season 0, 4 and 6 as in 1.
  lives.push_back(LifeWith({1, false, 0, 1}, 1, 4));
  lives.push_back(LifeWith({1, false, 0, 1}, 2, 6));
  lives.push_back(LifeWith({1, false, 1, 0}, 1, 7));
  lives.push_back(LifeWith({1, false, 1, 0}, 2, 7));
  const RelivedGeneration summary = Summary(lives, 2);
  CHECK(summary.swaps == 2);
  const RelivedMeasure& first = summary.of(kFitness, 0);
  CHECK(first.swapped == 1);
  CHECK(first.own == 12);
  CHECK(first.other == 5);
  CHECK(first.losses.median == 7);
  CHECK(summary.of(kFitness, 1).losses.median == -2);
}

TEST_CASE("of three seasons the others' medians count alike", "[relived]") {
  std::vector<RelivedSeason> lives;
  for (const int id : {1, 2, 9})
    for (int season = 0; season < 3; ++season)
      lives.push_back(LifeWith({id, false, season, season}, 1, 10));
  lives.push_back(LifeWith({1, false, 0, 1}, 1, 4));
  lives.push_back(LifeWith({1, false, 0, 2}, 1, 8));
  CHECK(Summary(lives, 3).of(kFitness, 0).losses.median == 4);
}

TEST_CASE("the best robot's lives by the other engine stand apart",
          "[relived]") {
  std::vector<RelivedSeason> lives;
  AddLives(1, {1}, lives);
  AddLives(2, {1}, lives);
  AddLives(9, {1}, lives);
  lives.push_back(LifeWith({9, true}, 1, 3));
  lives.push_back(LifeWith({9, true}, 2, 5));
  const RelivedGeneration summary = Summary(lives);
  CHECK(summary.other_lives == 2);
  CHECK(summary.of(kFitness, 0).best_by_other.quartiles.median == 4);
  CHECK(summary.of(kFitness, 0).best.quartiles.median == 1);
}

}  // namespace
}  // namespace plsc
