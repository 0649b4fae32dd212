#pragma once

// The tables of a run: what each column is, in SQL, comments included, so that
// `sqlite3 run.sqlite .schema` explains the file. docs/runs.md has the same in
// words. Descriptors are columns under the names of
// runtime/develop/descriptors.h.

#include <cstdint>
#include <string>
#include <vector>

namespace plsc {

class Database;

/// "plsc" in a file's header: PRAGMA application_id.
inline constexpr int kApplicationId = 0x706c7363;
/// "plsR": a file beside a run, of lives that its robots lived again
/// (runtime/relive).
inline constexpr int kRelivedApplicationId = 0x706c7352;
/// PRAGMA user_version. To be raised by 1 at every change of the schema.
inline constexpr int kSchemaVersion = 5;
/// Of the oldest that are read. Stores of schema 1 have no column run.results,
/// as all of them are of the first arithmetic (sim/results.h); before schema 3
/// there were neither servo errors and turns of the core nor the counts of
/// each generation (MissingMeasures), and before schema 4 no table `trial`, as
/// no robot lived a season twice. Schema 5 has more of behaviour, from where a
/// robot comes to be to what its way costs.
inline constexpr int kOldestSchema = 1;

enum class SchemaKind : std::uint8_t { kTable, kIndex, kView };

struct SchemaItem {
  std::string name;
  std::string sql;
  SchemaKind kind = SchemaKind::kTable;
  /// Of a table: a function of the experiment and the versions alone; else it
  /// depends on the clock or the machine.
  bool is_result = true;
  /// Columns that order its rows, whatever the order of writing.
  std::string order;
};

/// Tables before what refers to them, views last.
const std::vector<SchemaItem>& Schema(int version = kSchemaVersion);

/// The schema's version that a file says it has.
int SchemaOf(Database& database);

/// Names of descriptors as columns, "branching, branching_modules_count, ...".
std::vector<std::string> BodyColumns();
std::vector<std::string> BrainColumns();
std::vector<std::string> BehaviourColumns(int version = kSchemaVersion);

/// Of `generation`, in the order of CensusCounts (census.h); none before 3.
std::vector<std::string> CensusColumns(int version = kSchemaVersion);

/// Columns of behaviour that stores of this version lack and those of this
/// program have.
std::vector<std::string> MissingMeasures(int version);

}  // namespace plsc
