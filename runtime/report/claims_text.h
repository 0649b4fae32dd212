#pragma once

// The claims of a report for a terminal: a verdict each, and the numbers that
// it rests on.

#include <string>
#include <vector>

#include "runtime/report/claim_results.h"

namespace plsc {

/// Names are as they were written: whoever prints it escapes lines.
std::string ClaimsText(const StudyReport& report,
                       const std::vector<ClaimResult>& results);

}  // namespace plsc
