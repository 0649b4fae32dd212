#pragma once

// The claims of a report for a terminal: a verdict each, and the numbers that
// it rests on.

#include <string>
#include <string_view>
#include <vector>

#include "runtime/report/claim_results.h"

namespace plsc {

/// How it begins.
inline constexpr std::string_view kClaimsMark = "Claims, as 'plsc report' ";

/// For a terminal: no name can move its cursor.
std::string ClaimsText(const StudyReport& report,
                       const std::vector<ClaimResult>& results);

}  // namespace plsc
