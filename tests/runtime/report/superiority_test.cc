#include "runtime/report/superiority.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "runtime/report/wilcoxon.h"
#include "runtime/vary/rng.h"
#include "tests/runtime/report/r_rows.h"

namespace plsc {

namespace {

constexpr StreamKey kStream{17, 0, 1, Purpose::kBootstrap};

/// R's replicates are others, and ten times as many: its limits differ by four
/// of their standard errors at most, or by one of the steps that A has.
void CompareInterval(const Interval& ours, const test::RRow& row, double step) {
  const double spread = (row.numbers[2] - row.numbers[1]) / 4;
  const double margin = std::max(0.12 * spread, step) + 1e-9;
  CHECK(ours.low == Approx(row.numbers[1]).margin(margin));
  CHECK(ours.high == Approx(row.numbers[2]).margin(margin));
}

}  // namespace

TEST_CASE("A is W / (n m), and its interval an independent bootstrap's",
          "[superiority]") {
  for (const test::RRow& row : test::RRows("superiority")) {
    Rng rng(kStream);
    const Superiority ours = SuperiorityOf(row.x, row.y, rng);
    const auto pairs = static_cast<double>(row.x.size() * row.y.size());
    INFO(row.x.size() << " + " << row.y.size());
    CHECK(ours.a == Approx(row.numbers[0]).epsilon(1e-13));
    CHECK(ours.a == Approx(RankSumTest(row.x, row.y)->w / pairs));
    CompareInterval(ours.interval, row, 1 / pairs);
  }
}

TEST_CASE("Of pairs A is the share in which the first is above",
          "[superiority]") {
  for (const test::RRow& row : test::RRows("paired")) {
    Rng rng(kStream);
    const Superiority ours = PairedSuperiority(row.x, row.y, rng);
    CHECK(ours.a == Approx(row.numbers[0]).epsilon(1e-13));
    CompareInterval(ours.interval, row, 1 / static_cast<double>(row.x.size()));
  }
}

TEST_CASE("What is wholly apart, or wholly equal, is certain of nothing",
          "[superiority]") {
  Rng rng(kStream);
  const Superiority apart = SuperiorityOf({4, 5, 6}, {1, 2, 3}, rng);
  CHECK(apart.a == 1);
  // That no pair of three is otherwise: 0.025^(1/3).
  CHECK(apart.interval.low == Approx(0.29240177382128663));
  CHECK(apart.interval.high == 1);
  CHECK(SuperiorityOf({1}, {2}, rng).interval.high == Approx(0.975));
  const Superiority equal = SuperiorityOf({2, 2}, {2, 2}, rng);
  CHECK(equal.a == 0.5);
  CHECK(equal.interval.low == Approx(0.5 - 0.42094305849579055));
  CHECK(PairedSuperiority({2, 3, 4}, {1, 1, 1}, rng).interval.low ==
        Approx(0.29240177382128663));
  CHECK(PairedSuperiority({2}, {2}, rng).interval.low ==
        Approx(0.5 - 0.975 / 2));
}

TEST_CASE("The same stream gives the same bits", "[superiority]") {
  const std::vector<double> x = {1, 3, 5, 6, 9};
  const std::vector<double> y = {2, 3, 4, 4.5};
  Rng once(kStream);
  Rng again(kStream);
  CHECK(SuperiorityOf(x, y, once).interval ==
        SuperiorityOf(x, y, again).interval);
  // What the other sample is above, this one is below.
  Rng other(kStream);
  CHECK(SuperiorityOf(y, x, other).a ==
        Approx(1 - SuperiorityOf(x, y, once).a));
}

}  // namespace plsc
