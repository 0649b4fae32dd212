#include "runtime/evolve/consolidate.h"

#include <catch2/catch.hpp>
#include <cstddef>
#include <optional>
#include <vector>

#include "runtime/vary/rng.h"

namespace plsc {

namespace {

/// Every way to have one of the values nothing, 0, 1 and 2 in `seasons`.
std::vector<SeasonFitnesses> AllOf(std::size_t seasons) {
  std::vector<SeasonFitnesses> all = {{}};
  for (std::size_t i = 0; i < seasons; ++i) {
    std::vector<SeasonFitnesses> longer;
    for (const SeasonFitnesses& one : all)
      for (const std::optional<double>& value :
           {std::optional<double>(), std::optional<double>(0),
            std::optional<double>(1), std::optional<double>(2)}) {
        longer.push_back(one);
        longer.back().push_back(value);
      }
    all = std::move(longer);
  }
  return all;
}

/// The definition, with nothing as -1, which none of AllOf's numbers is.
bool DominatesByDefinition(const SeasonFitnesses& a, const SeasonFitnesses& b) {
  std::size_t worse = 0;
  std::size_t better = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    worse += a[i].value_or(-1) < b[i].value_or(-1) ? 1 : 0;
    better += a[i].value_or(-1) > b[i].value_or(-1) ? 1 : 0;
  }
  return worse == 0 && better > 0;
}

/// Better in more seasons than worse: right for two seasons, as the authors'
/// program had, and not for more.
bool DominatesBySigns(const SeasonFitnesses& a, const SeasonFitnesses& b) {
  int sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i].value_or(-1) > b[i].value_or(-1) ? 1 : 0;
    sum -= a[i].value_or(-1) < b[i].value_or(-1) ? 1 : 0;
  }
  return sum > 0;
}

}  // namespace

TEST_CASE("Domination is Pareto's, and nothing is worse than any number",
          "[consolidate]") {
  struct Row {
    const char* why;
    SeasonFitnesses a, b;
    bool a_dominates, b_dominates;
  };
  const std::optional<double> none;
  const std::vector<Row> rows = {
      {"better in the only season", {0.2}, {0.1}, true, false},
      {"equal", {0.1, 0.2}, {0.1, 0.2}, false, false},
      {"better in one, equal in one", {0.1, 0.3}, {0.1, 0.2}, true, false},
      {"better in one, worse in one", {0.0, 0.3}, {0.1, 0.2}, false, false},
      {"better in both", {0.2, 0.3}, {0.1, 0.2}, true, false},
      {"a number beats nothing", {-0.1, 0.2}, {none, 0.2}, true, false},
      {"nothing equals nothing", {none, 0.3}, {none, 0.2}, true, false},
      {"all nothing", {none, none}, {none, none}, false, false},
      {"nothing here, better there", {none, 0.3}, {0.1, 0.2}, false, false},
      {"three seasons: better, equal, worse (the authors' sum of signs "
       "would tie)",
       {0.2, 0.2, 0.2},
       {0.1, 0.2, 0.3},
       false,
       false},
      {"three seasons: better, better, worse is no domination",
       {0.2, 0.3, 0.1},
       {0.1, 0.2, 0.3},
       false,
       false},
      {"four seasons: better in the last only",
       {0.1, 0.1, 0.1, 0.2},
       {0.1, 0.1, 0.1, 0.1},
       true,
       false},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(Dominates(row.a, row.b) == row.a_dominates);
      CHECK(Dominates(row.b, row.a) == row.b_dominates);
    }
  }
}

TEST_CASE("The count is of those dominated in the set", "[consolidate]") {
  const std::optional<double> none;
  const std::vector<SeasonFitnesses> set = {
      {0.3, 0.1},    // dominates all but the second
      {0.1, 0.3},    // dominates the third and the last two
      {0.1, 0.1},    // dominates the last two
      {0.2, none},   // dominates the last two
      {none, none},  // none
      {none, none},  // its equal
  };
  CHECK(DominationCounts(set) == std::vector<int>{4, 3, 2, 2, 0, 0});
  CHECK(DominationCounts({}).empty());
}

TEST_CASE("Domination is the definition for up to four seasons",
          "[consolidate]") {
  for (std::size_t seasons = 1; seasons <= 4; ++seasons) {
    const std::vector<SeasonFitnesses> all = AllOf(seasons);
    int differences = 0;
    for (const SeasonFitnesses& a : all)
      for (const SeasonFitnesses& b : all) {
        const bool is_dominated = DominatesByDefinition(a, b);
        if (Dominates(a, b) != is_dominated) FAIL("at " << seasons);
        differences += DominatesBySigns(a, b) != is_dominated ? 1 : 0;
      }
    CAPTURE(seasons);
    // From three seasons on: better, better, worse.
    CHECK((differences > 0) == (seasons >= 3));
  }
}

TEST_CASE("Counts of random pools are those of comparing all pairs",
          "[consolidate]") {
  Rng rng({9301, 0, 0, Purpose::kSelectSurvivors});
  for (const std::size_t seasons : {1u, 2u, 3u, 5u}) {
    std::vector<SeasonFitnesses> pool(200);
    for (SeasonFitnesses& one : pool)
      for (std::size_t i = 0; i < seasons; ++i)
        // Few values, so that many are equal; every sixth is nothing.
        one.push_back(rng.Index(6) == 0
                          ? std::optional<double>()
                          : static_cast<double>(rng.Index(10)) / 100);
    const std::vector<int> counts = DominationCounts(pool);
    for (std::size_t i = 0; i < pool.size(); ++i) {
      int expected = 0;
      for (const SeasonFitnesses& other : pool)
        expected += DominatesByDefinition(pool[i], other) ? 1 : 0;
      REQUIRE(counts[i] == expected);
      if (seasons > 1) continue;
      // With one season the counts order the pool as its fitness does.
      for (std::size_t k = 0; k < pool.size(); ++k) {
        REQUIRE((counts[i] < counts[k]) == (pool[i][0] < pool[k][0]));
        REQUIRE((counts[i] == counts[k]) == (pool[i][0] == pool[k][0]));
      }
    }
  }
}

TEST_CASE("With one season the count orders as the fitness does",
          "[consolidate]") {
  const std::vector<SeasonFitnesses> set = {
      {0.5}, {-0.1}, {std::nullopt}, {0.5}, {0.02}};
  CHECK(DominationCounts(set) == std::vector<int>{3, 1, 0, 3, 2});
}

}  // namespace plsc
