#pragma once

// A report as one JSON object (docs/reports.md has its keys): what the page
// shows, and what `plsc report --format json` prints.

#include <string>

#include "runtime/report/claim_results.h"
#include "runtime/report/report.h"

namespace plsc {

/// `made`: who made it and when, "plsc 0.2.0" and UTC. Numbers of measures have
/// six digits: more than any figure shows, and half the size.
struct ReportMade {
  std::string by;
  std::string at;
};
std::string ReportJson(const StudyReport& report,
                       const std::vector<ClaimResult>& claims,
                       const ReportMade& made);

}  // namespace plsc
