#pragma once

// What a study expects before it is run, so that its report can say what holds
// and not only what was found. A claim is about one measure: of two experiments
// in a season, of two seasons of an experiment, or of one experiment in one
// season. Read from YAML by claim_yaml.h; docs/studies.md.

#include <cstdint>
#include <string>
#include <vector>

#include "grammar/enum_names.h"

namespace plsc {

enum class ClaimKind : std::uint8_t {
  kGreater,        ///< the first of two over the second
  kLess,           ///< under it
  kEqual,          ///< no more than a small effect between them
  kValue,          ///< one, against a published number
  kMinimumBefore,  ///< the curve of one falls, and rises before a generation
};
/// The keys that say which.
inline constexpr EnumNames<ClaimKind, 5> kClaimKindNames{
    {{ClaimKind::kGreater, "greater"},
     {ClaimKind::kLess, "less"},
     {ClaimKind::kEqual, "equal"},
     {ClaimKind::kValue, "value"},
     {ClaimKind::kMinimumBefore, "minimum_before"}}};

inline bool IsOfTwo(ClaimKind kind) {
  return kind <= ClaimKind::kEqual;
}

/// Which number of a run: of its population, or of its best robot.
enum class ClaimOf : std::uint8_t { kMean, kBest };
inline constexpr EnumNames<ClaimOf, 2> kClaimOfNames{
    {{ClaimOf::kMean, "mean"}, {ClaimOf::kBest, "best"}}};

/// How a published value sums up its runs.
enum class OverRuns : std::uint8_t { kMedian, kMean };
inline constexpr EnumNames<OverRuns, 2> kOverRunsNames{
    {{OverRuns::kMedian, "median"}, {OverRuns::kMean, "mean"}}};

struct Claim {
  std::string name;     ///< what is claimed, in words; of no other claim
  std::string measure;  ///< MeasureName of one
  ClaimOf of = ClaimOf::kMean;
  ClaimKind kind = ClaimKind::kGreater;
  /// Two of the one, which are compared, and one of the other; one each if the
  /// kind is not of two.
  std::vector<std::string> experiments;
  std::vector<std::string> seasons;
  double value = 0;  ///< kValue only, in the unit that the measure is shown in
  OverRuns over_runs = OverRuns::kMedian;  ///< kValue only
  int minimum_before = 0;                  ///< kMinimumBefore only, from 2
  std::string family;  ///< whose tests are corrected together
  std::string source;  ///< where the expectation is from

  friend bool operator==(const Claim&, const Claim&) = default;
};

/// Entries of a map, every line indented by `indent` blanks; empty without
/// claims. Two lists of claims are equal if and only if these texts are.
std::string PrintClaims(const std::vector<Claim>& claims, int indent);

}  // namespace plsc
