#include "runtime/evolve/consolidate.h"

#include <catch2/catch.hpp>
#include <vector>

namespace plsc {

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

TEST_CASE("With one season the count orders as the fitness does",
          "[consolidate]") {
  const std::vector<SeasonFitnesses> set = {
      {0.5}, {-0.1}, {std::nullopt}, {0.5}, {0.02}};
  CHECK(DominationCounts(set) == std::vector<int>{3, 1, 0, 3, 2});
}

}  // namespace plsc
