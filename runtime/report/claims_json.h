#pragma once

// The claims of a report as JSON: `claims` and `claims_stated`,
// docs/reports.md.

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "runtime/report/claim_results.h"

namespace plsc {

nlohmann::ordered_json ClaimsJson(const StudyReport& report,
                                  const std::vector<ClaimResult>& results);

/// Of each study that claims anything, every version of its claims; or what is
/// wrong with the record.
nlohmann::ordered_json ClaimsStatedJson(const StudyReport& report);

}  // namespace plsc
