#pragma once

// Relived lives in a report's JSON: of each run, and what swaps tell.

#include <nlohmann/json_fwd.hpp>

#include "runtime/report/report.h"

namespace plsc {

/// "relived" of a run that can be read: state, lives, and the best robot's
/// Speed by season in cm/s.
nlohmann::ordered_json RelivedOfRunJson(const ReportRun& run);

/// "swaps": as SwapLossesOf.
nlohmann::ordered_json SwapsJson(const StudyReport& report);

/// How many runs have relived lives, and what makes them of all.
nlohmann::ordered_json RelivedSummaryJson(const StudyReport& report);

}  // namespace plsc
