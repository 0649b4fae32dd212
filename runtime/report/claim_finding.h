#pragma once

// What runs say of one claim: the numbers, and the verdict. Pure functions of a
// number a run; the unit of all statistics is the run.

#include <cstdint>
#include <optional>
#include <vector>

#include "grammar/enum_names.h"
#include "runtime/report/interval.h"
#include "runtime/report/superiority.h"
#include "runtime/study/claim.h"

namespace plsc {

enum class Verdict : std::uint8_t {
  kHolds,
  kOpposite,    ///< what is claimed not to be was shown
  kNotShown,    ///< neither was
  kTooFewRuns,  ///< neither was, nor could be with so few
};
inline constexpr EnumNames<Verdict, 4> kVerdictNames{
    {{Verdict::kHolds, "holds"},
     {Verdict::kOpposite, "opposite"},
     {Verdict::kNotShown, "not shown"},
     {Verdict::kTooFewRuns, "too few runs"}}};

/// Errors of a verdict that holds are as rare.
inline constexpr double kLevel = 0.05;
/// What A may be if there is no more than a small effect (Vargha and Delaney's
/// bound of a medium one, to both sides).
inline constexpr Interval kSmallEffect{0.36, 0.64};

struct ClaimFinding {
  std::vector<std::size_t> runs;  ///< with a value, of what is compared
  std::vector<double> medians;    ///< likewise; no number without runs
  /// Of the medians, the first one's to the second's; both above 0.
  std::optional<double> ratio;
  std::optional<Superiority> effect;  ///< of two
  std::optional<double> p;            ///< of two: two-sided
  bool is_exact = false;              ///< p
  bool is_paired = false;             ///< seasons of the same runs
  std::optional<double> holm;         ///< p, corrected for its family
  std::optional<double> ours;         ///< kValue: the median or mean over runs
  std::optional<int> minimum;  ///< kMinimumBefore: of the median curve, when
  std::size_t runs_so = 0;     ///< kMinimumBefore: in whose curves it is so
  /// Of `ours`, or of the share of runs in which it is so.
  std::optional<Interval> interval;
  Verdict verdict = Verdict::kTooFewRuns;
};

/// Two samples, or pairs. The verdict is open until JudgeOfTwo.
ClaimFinding FindingOfTwo(const std::vector<double>& x,
                          const std::vector<double>& y, bool is_paired,
                          Rng& rng);
/// `family`: how many tests are corrected together, this one included.
void JudgeOfTwo(ClaimKind kind, std::size_t family, ClaimFinding& finding);

/// Against a published number.
ClaimFinding FindingOfValue(const std::vector<double>& values, double published,
                            OverRuns over_runs, Rng& rng);

/// Of curves by generation, all as long: whether they fall first, and are at
/// their lowest before generation `before`.
ClaimFinding FindingOfCourse(const std::vector<std::vector<double>>& curves,
                             int before);

}  // namespace plsc
