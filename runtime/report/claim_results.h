#pragma once

// The claims of a report's studies, with what became of them.

#include <optional>
#include <string>
#include <vector>

#include "runtime/report/claim_finding.h"
#include "runtime/report/report.h"

namespace plsc {

struct ClaimResult {
  std::size_t study = 0;  ///< index into StudyReport::claims
  StatedClaim stated;
  std::vector<std::size_t> planned;  ///< runs, of what is compared
  /// Of these, those that have completed the generation that is compared. That
  /// a finding has fewer says that the others have no such value.
  std::vector<std::size_t> completed;
  /// Not all of these have completed all of their generations: a look ahead.
  bool is_early = false;
  std::size_t family = 1;  ///< tests that are corrected together
  ClaimFinding recorded;
  /// By lives that were lived again, of measures that these may change.
  std::optional<ClaimFinding> relived;

  /// A record is one lucky draw, so what was lived again is told first; but
  /// only if it is of no fewer runs: who chose some of them chose a result.
  bool IsRelivedFirst() const;
  const ClaimFinding& first() const {
    return IsRelivedFirst() ? *relived : recorded;
  }
};

/// In the order of studies; of each as StatedClaims has them. A claim that was
/// withdrawn is told, and counts in its family, nevertheless.
std::vector<ClaimResult> ClaimResultsOf(const StudyReport& report);

/// The claim's measure as the report shows it.
std::optional<ReportMeasure> MeasureOf(const StudyReport& report,
                                       const Claim& claim);

/// "17 claims: 9 hold, 2 opposite, 6 not shown"; empty without any.
std::string ClaimsSummary(const std::vector<ClaimResult>& results);

/// "plastic > baseline, flat", "flat: plastic 3.63 cm/s"...
std::string WhatIsClaimed(const Claim& claim);

}  // namespace plsc
