#include "runtime/evolve/select.h"

#include <catch2/catch.hpp>
#include <set>
#include <vector>

#include "tests/runtime/vary/chi_square.h"

namespace plsc {

using test::kSignificance;
using test::PValue;

TEST_CASE("The best of the drawn wins, of equal ones the first drawn",
          "[select]") {
  const std::vector<int> scores = {4, 9, 4, 0};
  for (std::uint64_t id = 0; id < 500; ++id) {
    const StreamKey key{11, 0, id, Purpose::kSelectParents};
    Rng drawn(key);
    const std::size_t first = drawn.Index(4);
    const std::size_t second = drawn.Index(4);
    Rng rng(key);
    const std::size_t expected =
        scores[second] > scores[first] ? second : first;
    CHECK(Tournament(scores, 2, rng) == expected);
  }
}

TEST_CASE("Winners are as likely as theory says", "[select]") {
  // Of n with ranks 1..n a tournament of k is won by rank r with probability
  // (r^k - (r-1)^k) / n^k.
  const std::vector<int> scores = {10, 20, 30, 40, 50};
  struct Row {
    int size;
    std::vector<double> expected;
  };
  for (const Row& row : std::vector<Row>{{1, {1, 1, 1, 1, 1}},
                                         {2, {1, 3, 5, 7, 9}},
                                         {3, {1, 7, 19, 37, 61}}}) {
    CAPTURE(row.size);
    Rng rng({12, 0, 0, Purpose::kSelectParents});
    std::vector<int> wins(5);
    for (int i = 0; i < 20000; ++i) ++wins[Tournament(scores, row.size, rng)];
    CHECK(PValue(wins, row.expected) > kSignificance);
  }
}

TEST_CASE("Selected individuals are distinct", "[select]") {
  std::vector<int> scores(200);
  for (std::size_t i = 0; i < scores.size(); ++i)
    scores[i] = static_cast<int>(i % 50);
  Rng rng({13, 0, 0, Purpose::kSelectSurvivors});
  const std::vector<std::size_t> chosen = SelectDistinct(scores, 100, 2, rng);
  CHECK(chosen.size() == 100);
  CHECK(std::set<std::size_t>(chosen.begin(), chosen.end()).size() == 100);
}

TEST_CASE("Survivors are as likely as drawing until enough have won",
          "[select]") {
  // Of scores 1, 2, 3 in tournaments of 2, winners have 1/9, 3/9, 5/9; who of
  // three is left out of two survivors follows from the pairs in order.
  const std::vector<double> wins = {1.0 / 9, 3.0 / 9, 5.0 / 9};
  std::vector<double> left_out(3);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (i != k) left_out[3 - i - k] += wins[i] * wins[k] / (1 - wins[i]);
  std::vector<int> counts(3);
  for (std::uint64_t id = 0; id < 20000; ++id) {
    Rng rng({16, id, 0, Purpose::kSelectSurvivors});
    const auto chosen = SelectDistinct({1, 2, 3}, 2, 2, rng);
    REQUIRE(chosen[0] != chosen[1]);
    ++counts[3 - chosen[0] - chosen[1]];
  }
  CHECK(PValue(counts, left_out) > kSignificance);
  CHECK(PValue(counts, std::vector<double>{3, 2, 1}) < kSignificance);
}

TEST_CASE("The second parent is a winner that is not the first", "[select]") {
  // Of scores 1, 2, 3 in tournaments of 2 the winners have 1/9, 3/9, 5/9;
  // given the first, the second has its share of what is left.
  const std::vector<int> scores = {1, 2, 3};
  Rng rng({14, 0, 0, Purpose::kSelectParents});
  std::vector<int> pairs(9);
  for (int i = 0; i < 20000; ++i) {
    const auto pair = SelectDistinct(scores, 2, 2, rng);
    ++pairs[pair[0] * 3 + pair[1]];
  }
  CHECK(pairs[0] + pairs[4] + pairs[8] == 0);
  const std::vector<int> seen = {pairs[1], pairs[2], pairs[3],
                                 pairs[5], pairs[6], pairs[7]};
  const std::vector<double> expected = {1.0 * 3 / 8, 1.0 * 5 / 8, 3.0 * 1 / 6,
                                        3.0 * 5 / 6, 5.0 * 1 / 4, 5.0 * 3 / 4};
  CHECK(PValue(seen, expected) > kSignificance);
}

TEST_CASE("Selecting everybody ends even where the worst cannot win",
          "[select]") {
  // The second of four wins a tournament of 30 with 2^-30 only, the first
  // with 4^-30.
  Rng rng({15, 0, 0, Purpose::kSelectSurvivors});
  const auto chosen = SelectDistinct({0, 1, 2, 3}, 4, 30, rng);
  CHECK(chosen == std::vector<std::size_t>{3, 2, 1, 0});
}

}  // namespace plsc
