#pragma once

// A report's numbers as tables that stand by themselves, for version control,
// spreadsheets and papers: what the page shows but curves by generation.

#include <string>
#include <vector>

#include "runtime/report/claim_results.h"
#include "runtime/report/report.h"

namespace plsc {

struct Table {
  std::string name;   ///< of its file, without an ending
  std::string title;  ///< in words
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// How every table begins as CSV, and has near its beginning.
inline constexpr std::string_view kTableMark = "study,values,";
/// How TablesMarkdown begins.
inline constexpr std::string_view kTablesMark = "<!-- Made by plsc report -->";

/// Claims, boxes, tests, swaps, runs: always all of them, some without rows.
std::vector<Table> TablesOf(const StudyReport& report,
                            const std::vector<ClaimResult>& claims);

/// RFC 4180, six digits.
std::string TableCsv(const Table& table);

/// All but the runs, which are for programs, under the report's title.
std::string TablesMarkdown(const StudyReport& report,
                           const std::vector<Table>& tables);

}  // namespace plsc
