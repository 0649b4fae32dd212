#pragma once

// A run as files for other tools: tables with commas, or a JSON object a line.
// Functions of the results alone: equal runs give equal bytes. Runs that are
// not finished, are worked on, or are damaged in parts are written as far as
// they can be read.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/store/run_store.h"

namespace plsc {

/// Takes the next piece of a file; what went wrong with it, or nothing.
using Sink = std::function<std::optional<std::string>(std::string_view)>;

/// The tables of a run for the eye and the spreadsheet, each a CSV file of
/// that name: what it has is a SELECT.
struct CsvTable {
  std::string name;  ///< "individuals"
  std::string sql;
};
const std::vector<CsvTable>& CsvTables();

/// RFC 4180, a header first, doubles as the shortest text that reads back to
/// the same, NULL as nothing.
std::optional<std::string> WriteCsv(const std::string& run,
                                    const CsvTable& table, const Sink& sink);

/// {"run": ...}, then an object an individual in order of id, {"individual":
/// ...} with its seasons as `plsc simulate --format json` has them, then one a
/// generation, {"generation": ...}.
std::optional<std::string> WriteJsonl(const std::string& run, const Sink& sink);

}  // namespace plsc
