#pragma once

// A run as files for other tools: tables with commas, or a JSON object a line.
// Functions of the results alone: equal runs give equal bytes. Runs that are
// not finished or are worked on are written as far as they are. All that is
// written was compared with its checksums; of a damaged run what is whole is
// written, and the damage is told.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/failure.h"
#include "runtime/store/run_store.h"

namespace plsc {

/// Takes the next piece of a file; what went wrong with it, or nothing.
using Sink = std::function<MaybeFailure(std::string_view)>;

/// What tells whether a row of a table is whole: the number in its first cell.
enum class CsvRows : std::uint8_t {
  kOfRun,
  kOfBirths,       ///< a robot's id
  kOfEvaluations,  ///< likewise
  kOfGenerations,  ///< a generation
  kOfRobots,       ///< the key of a phenotype
};

/// The tables of a run for the eye and the spreadsheet, each a CSV file of
/// that name: what it has is a SELECT.
struct CsvTable {
  std::string name;  ///< "individuals"
  CsvRows rows;
  std::string sql;
};
const std::vector<CsvTable>& CsvTables();

/// RFC 4180, a header first, doubles as the shortest text that reads back to
/// the same, NULL as nothing. A text that a spreadsheet would take for a
/// formula is led by an apostrophe. What is sensed is typed as in all JSON.
class CsvExport {
 public:
  CsvExport();
  ~CsvExport();
  CsvExport(const CsvExport&) = delete;
  CsvExport& operator=(const CsvExport&) = delete;

  /// What the run is must be whole. All tables are of this instant.
  MaybeFailure Open(const std::string& run);
  MaybeFailure Write(const CsvTable& table, const Sink& sink);
  /// What is wrong with the run; none of it is in any table.
  const MaybeFailure& damage() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// {"run": ...}, then an object an individual in order of id, {"individual":
/// ...} with its seasons as `plsc simulate --format json` has them, then one a
/// generation, {"generation": ...}. What is damaged is left out and told.
MaybeFailure WriteJsonl(const std::string& run, const Sink& sink);

}  // namespace plsc
