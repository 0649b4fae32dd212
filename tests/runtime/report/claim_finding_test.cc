#include "runtime/report/claim_finding.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "runtime/vary/rng.h"
#include "tests/runtime/report/r_rows.h"

namespace plsc {

namespace {

using Values = std::vector<double>;

constexpr StreamKey kFindingStream{17, 0, 2, Purpose::kBootstrap};

/// `count` values from `first` on, `step` apart.
Values Run(int count, double first, double step = 1) {
  Values values;
  for (int i = 0; i < count; ++i) values.push_back(first + i * step);
  return values;
}

/// As the only test of its family, or with others that show as much.
Verdict VerdictOf(ClaimKind kind, const Values& x, const Values& y,
                  std::size_t family = 1, bool is_paired = false) {
  Rng rng(kFindingStream);
  ClaimFinding finding = FindingOfTwo(x, y, is_paired, rng);
  if (finding.p) finding.holm = std::min(1.0, *finding.p * double(family));
  JudgeOfTwo(kind, family, finding);
  return finding.verdict;
}

}  // namespace

TEST_CASE("Greater holds, is the opposite, or is not shown",
          "[claim_finding]") {
  using enum ClaimKind;
  using enum Verdict;
  const Values low = Run(10, 0);
  const Values high = Run(10, 9.5);
  CHECK(VerdictOf(kGreater, high, low) == kHolds);
  CHECK(VerdictOf(kGreater, low, high) == kOpposite);
  CHECK(VerdictOf(kLess, low, high) == kHolds);
  CHECK(VerdictOf(kLess, high, low) == kOpposite);
  CHECK(VerdictOf(kGreater, Run(10, 0.5), low) == kNotShown);
  // The same values everywhere are a difference of nothing.
  CHECK(VerdictOf(kGreater, Values(10, 3), Values(10, 3)) == kNotShown);
}

// 2 / (2 n over n) is 0.1 for 3 and 0.029 for 4 runs of each; 2 / 2^n is 0.0625
// for 5 and 0.031 for 6 pairs.
TEST_CASE("So few runs that no values could show it are told",
          "[claim_finding]") {
  using enum ClaimKind;
  using enum Verdict;
  CHECK(VerdictOf(kGreater, Run(3, 9), Run(3, 0)) == kTooFewRuns);
  CHECK(VerdictOf(kGreater, Run(4, 9), Run(4, 0)) == kHolds);
  CHECK(VerdictOf(kGreater, Run(4, 0), Run(4, 0.5)) == kNotShown);
  // Of a family of six, five of each are needed.
  CHECK(VerdictOf(kGreater, Run(4, 9), Run(4, 0), 6) == kTooFewRuns);
  CHECK(VerdictOf(kGreater, Run(5, 9), Run(5, 0), 6) == kHolds);
  CHECK(VerdictOf(kLess, {}, Run(9, 0)) == kTooFewRuns);
  CHECK(VerdictOf(kGreater, Run(5, 9), Run(5, 0, 0.5), 1, true) == kTooFewRuns);
  CHECK(VerdictOf(kGreater, Run(6, 9), Run(6, 0, 0.5), 1, true) == kHolds);
  CHECK(VerdictOf(kGreater, Run(6, 0, 0.5), Run(6, 9), 1, true) == kOpposite);
}

TEST_CASE("Equal rests on the interval of A and not on p", "[claim_finding]") {
  using enum ClaimKind;
  using enum Verdict;
  // As even as can be: 1.96 sqrt((n + m + 1) / (12 n m)) is 0.14 for 33 of
  // each.
  CHECK(VerdictOf(kEqual, Run(20, 0, 2), Run(20, 0.9, 2)) == kTooFewRuns);
  CHECK(VerdictOf(kEqual, Run(60, 0, 2), Run(60, 0.9, 2)) == kHolds);
  CHECK(VerdictOf(kEqual, Run(60, 0), Run(60, 8)) == kNotShown);
  CHECK(VerdictOf(kEqual, Run(60, 0), Run(60, 40)) == kOpposite);
  CHECK(VerdictOf(kEqual, Run(60, 40), Run(60, 0)) == kOpposite);
  // Nothing of any run differs: a dozen are enough, a few are not.
  CHECK(VerdictOf(kEqual, Values(12, 0), Values(12, 0)) == kHolds);
  CHECK(VerdictOf(kEqual, Values(4, 0), Values(4, 0)) == kTooFewRuns);
  // Wholly apart is no small effect, once there are enough of it.
  CHECK(VerdictOf(kEqual, Run(9, 20), Run(9, 0)) == kOpposite);
  CHECK(VerdictOf(kEqual, Run(5, 20), Run(5, 0)) == kTooFewRuns);
}

TEST_CASE("Medians, their ratio and p are told", "[claim_finding]") {
  Rng rng(kFindingStream);
  const ClaimFinding finding =
      FindingOfTwo({4, 6, 8}, {1, 2, 3, 10}, false, rng);
  CHECK(finding.runs == std::vector<std::size_t>{3, 4});
  CHECK(finding.medians == Values{6, 2.5});
  CHECK(*finding.ratio == Approx(2.4));
  CHECK(finding.effect->a == Approx(9.0 / 12));
  CHECK(*finding.p == Approx(0.4));  // R's wilcox.test
  CHECK(finding.is_exact);
  CHECK_FALSE(FindingOfTwo({-1, 2, 3}, {-2, -1, 1}, false, rng).ratio);
  // R's wilcox.test(x, y, paired = TRUE)
  const ClaimFinding pairs =
      FindingOfTwo({1, 2, 3, 4.5}, {0, 4, 0, 0}, true, rng);
  CHECK(*pairs.p == Approx(0.375));
  CHECK(pairs.effect->a == 0.75);
}

TEST_CASE("A published value is held against an interval of ours",
          "[claim_finding]") {
  for (const bool is_mean : {false, true})
    for (const test::RRow& row : test::RRows(is_mean ? "mean" : "median")) {
      Rng rng(kFindingStream);
      const ClaimFinding ours =
          FindingOfValue(row.x, row.numbers[0],
                         is_mean ? OverRuns::kMean : OverRuns::kMedian, rng);
      INFO((is_mean ? "mean of " : "median of ") << row.x.size());
      CHECK(*ours.ours == Approx(row.numbers[0]).epsilon(1e-12));
      CHECK(*ours.ratio == Approx(1));
      const double spread = (row.numbers[2] - row.numbers[1]) / 4;
      CHECK(ours.interval->low ==
            Approx(row.numbers[1]).margin(0.12 * spread + 1e-9));
      CHECK(ours.interval->high ==
            Approx(row.numbers[2]).margin(0.12 * spread + 1e-9));
      CHECK(ours.verdict == Verdict::kHolds);
    }
  Rng rng(kFindingStream);
  const auto verdict = [&](const Values& values, double published) {
    return FindingOfValue(values, published, OverRuns::kMedian, rng).verdict;
  };
  CHECK(verdict(Run(9, 1), 5.5) == Verdict::kHolds);
  CHECK(verdict(Run(9, 1), 9.5) == Verdict::kOpposite);
  CHECK(verdict(Run(9, 1), 0.5) == Verdict::kOpposite);
  CHECK(verdict(Run(5, 1), 3) == Verdict::kTooFewRuns);
  CHECK(verdict({}, 3) == Verdict::kTooFewRuns);
}

TEST_CASE("A course falls first, and rises before a generation",
          "[claim_finding]") {
  const auto find = [](const std::vector<Values>& curves) {
    return FindingOfCourse(curves, 3);
  };
  const Values dips = {5, 4, 3, 6, 7};
  const Values rises = {5, 6, 7, 8, 9};
  const Values falls = {5, 4, 3, 2, 1};
  const ClaimFinding all = find(std::vector<Values>(8, dips));
  CHECK(all.verdict == Verdict::kHolds);
  CHECK(*all.minimum == 2);
  CHECK(all.runs_so == 8);
  CHECK(all.medians[0] == 3);
  CHECK(find(std::vector<Values>(8, rises)).verdict == Verdict::kOpposite);
  CHECK(find(std::vector<Values>(8, falls)).verdict == Verdict::kOpposite);
  CHECK(*find(std::vector<Values>(8, falls)).minimum == 4);
  CHECK(find(std::vector<Values>(5, dips)).verdict == Verdict::kTooFewRuns);
  CHECK(find({}).verdict == Verdict::kTooFewRuns);
  CHECK(find({dips, dips, dips, dips, rises, falls}).verdict ==
        Verdict::kNotShown);
  // Of curves that were thinned out, or had no robot with a value.
  CHECK(*find({{5, NAN, 3, NAN, 7}}).minimum == 2);
  CHECK_FALSE(find({{NAN, NAN}}).minimum);
}

}  // namespace plsc
