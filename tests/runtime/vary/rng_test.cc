#include "runtime/vary/rng.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <vector>

#include "tests/runtime/vary/chi_square.h"

namespace plsc {

using test::kSignificance;
using test::PValue;

TEST_CASE("The first block is the published answer of Philox4x64-10", "[rng]") {
  // Random123's known-answer test with counter and key zero.
  Rng rng({0, 0, 0, Purpose::kInitialise});
  CHECK(rng.Next() == 0x16554d9eca36314cULL);
  CHECK(rng.Next() == 0xdb20fe9d672d0fdcULL);
  CHECK(rng.Next() == 0xd7e772cee186176bULL);
  CHECK(rng.Next() == 0x7e68b68aec7ba23bULL);
}

TEST_CASE("Equal keys give equal streams, any other key another", "[rng]") {
  const StreamKey key{7, 3, 12, Purpose::kMutate};
  const std::vector<StreamKey> others = {{8, 3, 12, Purpose::kMutate},
                                         {7, 4, 12, Purpose::kMutate},
                                         {7, 3, 13, Purpose::kMutate},
                                         {7, 3, 12, Purpose::kCrossover}};
  Rng a(key), b(key);
  std::set<std::uint64_t> first_words;
  for (int i = 0; i < 100; ++i) {
    const std::uint64_t word = a.Next();
    CHECK(word == b.Next());
    first_words.insert(word);
  }
  for (const StreamKey& other : others) {
    Rng rng(other);
    for (int i = 0; i < 100; ++i) first_words.insert(rng.Next());
  }
  CHECK(first_words.size() == 500);
}

TEST_CASE("Uniform numbers fill their interval evenly", "[rng]") {
  Rng rng({1, 0, 0, Purpose::kInitialise});
  std::vector<int> tenths(10);
  for (int i = 0; i < 20000; ++i) {
    const double x = rng.Uniform(-1, 1);
    REQUIRE(x >= -1);
    REQUIRE(x <= 1);
    ++tenths[static_cast<std::size_t>((x + 1) * 5)];
  }
  CHECK(PValue(tenths, std::vector<double>(10, 1)) > kSignificance);
  CHECK(rng.Uniform(2.5, 2.5) == 2.5);
}

TEST_CASE("Every index is as likely, whatever the count", "[rng]") {
  for (const std::size_t count : {1u, 2u, 3u, 5u, 7u, 19u}) {
    CAPTURE(count);
    Rng rng({2, 0, count, Purpose::kInitialise});
    std::vector<int> counts(count);
    for (int i = 0; i < 20000; ++i) ++counts[rng.Index(count)];
    if (count > 1)
      CHECK(PValue(counts, std::vector<double>(count, 1)) > kSignificance);
  }
  // With 2^63 + 1 indices nearly half of the words are refused; taking the
  // remainder without refusing would give 0 to 2^63 - 2 twice as often.
  const std::size_t huge = (std::size_t{1} << 63) + 1;
  Rng rng({3, 0, 0, Purpose::kInitialise});
  std::vector<int> halves(2);
  for (int i = 0; i < 20000; ++i) {
    const std::size_t index = rng.Index(huge);
    REQUIRE(index < huge);
    ++halves[index < huge / 2 ? 0 : 1];
  }
  CHECK(PValue(halves, std::vector<double>{1, 1}) > kSignificance);
}

TEST_CASE("A Bernoulli draw is true with its probability", "[rng]") {
  Rng rng({4, 0, 0, Purpose::kInitialise});
  std::vector<int> counts(2);
  for (int i = 0; i < 20000; ++i) ++counts[rng.Bernoulli(0.8) ? 0 : 1];
  CHECK(PValue(counts, std::vector<double>{0.8, 0.2}) > kSignificance);
  for (int i = 0; i < 100; ++i) {
    CHECK(rng.Bernoulli(1));
    CHECK_FALSE(rng.Bernoulli(0));
  }
}

TEST_CASE("Normal numbers follow the normal distribution", "[rng]") {
  Rng rng({5, 0, 0, Purpose::kInitialise});
  const auto cumulative = [](double x) {
    return std::erfc(-x / std::sqrt(2.0)) / 2;
  };
  // Cells of half a standard deviation from -3 to 3, and the tails.
  std::vector<int> counts(14);
  std::vector<double> expected(14);
  double below = 0;
  for (std::size_t i = 0; i < 14; ++i) {
    const double up_to =
        i == 13 ? 1 : cumulative(-3 + 0.5 * static_cast<double>(i));
    expected[i] = up_to - below;
    below = up_to;
  }
  for (int i = 0; i < 20000; ++i) {
    const double cell = std::floor(rng.Normal() * 2) + 7;
    ++counts[static_cast<std::size_t>(std::min(std::max(cell, 0.0), 13.0))];
  }
  CHECK(PValue(counts, expected) > kSignificance);
}

}  // namespace plsc
