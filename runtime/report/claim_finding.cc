// A verdict needs evidence of its own: "not significant" is no evidence of
// anything. So greater and less rest on a test that is corrected for its
// family, equal and opposite of equal on an interval, and where neither side is
// shown the question is whether so few runs could have shown it at all:
//   greater, less  even samples that are wholly apart have an exact p of
//                  2 / (n + m over n), of pairs 2 / 2^n, and Holm multiplies
//                  the smallest by the size of the family
//   equal          with no difference at all A scatters by about
//                  sqrt((n + m + 1) / (12 n m)), in pairs 1 / (2 sqrt(n)), and
//                  1.96 of that must fit between 0.5 and the bound: 33 + 33
//                  runs
//   value          the outer ones of 5 runs lie around their median less often
//                  than 95 times in a hundred: 6 runs
//   course         so do the limits of a share of 5 of 5 runs and the half

#include "runtime/report/claim_finding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/report/quantiles.h"
#include "runtime/report/signed_rank.h"
#include "runtime/report/wilcoxon.h"
#include "runtime/vary/rng.h"

namespace plsc {

namespace {

constexpr int kReplicatesOfValue = 10'000;
constexpr std::size_t kFewestRuns = 6;    // of one sample
constexpr double kZ = 1.959963984540054;  // of 95 %

double MedianOf(const std::vector<double>& values) {
  return QuartilesOf(values).median;
}

/// Of samples, or pairs, that are wholly apart.
double LeastP(const ClaimFinding& finding) {
  const auto n = static_cast<double>(finding.runs[0]);
  const auto m = static_cast<double>(finding.runs[1]);
  const double log_ways =
      finding.is_paired
          ? n * std::log(2)
          : std::lgamma(n + m + 1) - std::lgamma(n + 1) - std::lgamma(m + 1);
  return std::min(1.0, 2 * std::exp(-log_ways));
}

/// How far the interval of A reaches where there is no difference.
double ReachOfEqual(const ClaimFinding& finding) {
  const auto n = static_cast<double>(finding.runs[0]);
  const auto m = static_cast<double>(finding.runs[1]);
  return kZ * (finding.is_paired ? 0.5 / std::sqrt(n)
                                 : std::sqrt((n + m + 1) / (12 * n * m)));
}

Verdict OfEqual(const ClaimFinding& finding) {
  const Interval& interval = finding.effect->interval;
  if (interval.low >= kSmallEffect.low && interval.high <= kSmallEffect.high)
    return Verdict::kHolds;
  if (interval.low > kSmallEffect.high || interval.high < kSmallEffect.low)
    return Verdict::kOpposite;
  return ReachOfEqual(finding) > (kSmallEffect.high - kSmallEffect.low) / 2
             ? Verdict::kTooFewRuns
             : Verdict::kNotShown;
}

Verdict OfDirection(ClaimKind kind, std::size_t family,
                    const ClaimFinding& finding) {
  constexpr double kNeither = 0.5;
  if (finding.holm && *finding.holm < kLevel) {
    const bool is_above = finding.effect->a > kNeither;
    return is_above == (kind == ClaimKind::kGreater) ? Verdict::kHolds
                                                     : Verdict::kOpposite;
  }
  return LeastP(finding) * static_cast<double>(family) >= kLevel
             ? Verdict::kTooFewRuns
             : Verdict::kNotShown;
}

void TestTwo(const std::vector<double>& x, const std::vector<double>& y,
             ClaimFinding& finding) {
  if (!finding.is_paired) {
    const auto test = RankSumTest(x, y);
    // All values are equal: nothing speaks against that.
    finding.p = test ? test->p : 1;
    finding.is_exact = !test || test->is_exact;
    return;
  }
  std::vector<double> differences;
  for (std::size_t i = 0; i < x.size(); ++i) differences.push_back(x[i] - y[i]);
  const auto test = SignedRankTest(differences);
  finding.p = test ? test->p : 1;
  finding.is_exact = true;
}

std::vector<double> Replicates(const std::vector<double>& values,
                               OverRuns over_runs, Rng& rng) {
  std::vector<double> replicates;
  std::vector<double> drawn(values.size());
  for (int i = 0; i < kReplicatesOfValue; ++i) {
    for (double& one : drawn) one = values[rng.Index(values.size())];
    replicates.push_back(over_runs == OverRuns::kMean ? MeanOf(drawn)
                                                      : MedianOf(drawn));
  }
  return replicates;
}

/// When a curve is at its lowest first; nothing where it has no numbers.
std::optional<int> MinimumOf(const std::vector<double>& curve) {
  std::optional<int> minimum;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < curve.size(); ++i)
    if (curve[i] < least) {
      least = curve[i];
      minimum = static_cast<int>(i);
    }
  return minimum;
}

bool FallsThenRises(std::optional<int> minimum, int before) {
  return minimum && *minimum > 0 && *minimum < before;
}

}  // namespace

ClaimFinding FindingOfTwo(const std::vector<double>& x,
                          const std::vector<double>& y, bool is_paired,
                          Rng& rng) {
  ClaimFinding finding;
  finding.runs = {x.size(), y.size()};
  finding.medians = {MedianOf(x), MedianOf(y)};
  finding.is_paired = is_paired;
  if (x.empty() || y.empty()) return finding;
  if (finding.medians[0] > 0 && finding.medians[1] > 0)
    finding.ratio = finding.medians[0] / finding.medians[1];
  finding.effect =
      is_paired ? PairedSuperiority(x, y, rng) : SuperiorityOf(x, y, rng);
  TestTwo(x, y, finding);
  return finding;
}

void JudgeOfTwo(ClaimKind kind, std::size_t family, ClaimFinding& finding) {
  if (finding.effect)
    finding.verdict = kind == ClaimKind::kEqual
                          ? OfEqual(finding)
                          : OfDirection(kind, family, finding);
}

ClaimFinding FindingOfValue(const std::vector<double>& values, double published,
                            OverRuns over_runs, Rng& rng) {
  ClaimFinding finding;
  finding.runs = {values.size()};
  finding.medians = {MedianOf(values)};
  if (values.empty()) return finding;
  const bool is_mean = over_runs == OverRuns::kMean;
  finding.ours = is_mean ? MeanOf(values) : finding.medians[0];
  if (*finding.ours > 0 && published > 0)
    finding.ratio = *finding.ours / published;
  if (values.size() < kFewestRuns) return finding;
  std::vector<double> replicates = Replicates(values, over_runs, rng);
  std::vector<double> left_out;
  const auto n = static_cast<double>(values.size());
  for (const double value : values)
    left_out.push_back((n * MeanOf(values) - value) / (n - 1));
  // A median has steps, and no skewness that leaving out one would show.
  finding.interval =
      is_mean ? BcaInterval(std::move(replicates), *finding.ours, {left_out})
              : PercentileInterval(std::move(replicates));
  finding.verdict =
      finding.interval->low <= published && published <= finding.interval->high
          ? Verdict::kHolds
          : Verdict::kOpposite;
  return finding;
}

ClaimFinding FindingOfCourse(const std::vector<std::vector<double>>& curves,
                             int before) {
  constexpr double kHalf = 0.5;
  ClaimFinding finding;
  finding.runs = {curves.size()};
  if (curves.empty()) {
    finding.medians = {MedianOf({})};
    return finding;
  }
  std::vector<double> median;
  for (std::size_t i = 0; i < curves[0].size(); ++i) {
    std::vector<double> at;
    for (const std::vector<double>& curve : curves)
      if (!std::isnan(curve[i])) at.push_back(curve[i]);
    median.push_back(MedianOf(at));
  }
  finding.minimum = MinimumOf(median);
  finding.medians = {finding.minimum
                         ? median[static_cast<std::size_t>(*finding.minimum)]
                         : MedianOf({})};
  for (const std::vector<double>& curve : curves)
    if (FallsThenRises(MinimumOf(curve), before)) ++finding.runs_so;
  finding.interval = ShareInterval(finding.runs_so, curves.size());
  const bool is_so = FallsThenRises(finding.minimum, before);
  if (is_so && finding.interval->low > kHalf)
    finding.verdict = Verdict::kHolds;
  else if (!is_so && finding.interval->high < kHalf)
    finding.verdict = Verdict::kOpposite;
  else if (curves.size() >= kFewestRuns)
    finding.verdict = Verdict::kNotShown;
  return finding;
}

}  // namespace plsc
