#pragma once

// A report as a folder of tables and figures, for version control and papers.

#include "runtime/cli/arguments/report.h"
#include "runtime/cli/files/io.h"
#include "runtime/report/claim_results.h"
#include "runtime/report/report.h"

namespace plsc::cli {

/// Whether all of its files can be written, asked before the work; makes the
/// folder. Prints what is wrong.
bool CanWriteFiles(const ReportCommand& command, Io& io);

/// Writes them, and leaves what else is in the folder.
bool WriteFiles(const ReportCommand& command, const StudyReport& report,
                const std::vector<ClaimResult>& claims, Io& io);

}  // namespace plsc::cli
