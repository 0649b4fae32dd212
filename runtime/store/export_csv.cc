#include <fmt/format.h>

#include <utility>

#include "runtime/store/database.h"
#include "runtime/store/export.h"
#include "runtime/store/verify.h"

namespace plsc {

namespace {

std::string Quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c;
    if (c == '"') quoted += c;
  }
  return quoted + '"';
}

std::string Cell(Statement& row) {
  switch (row.Type()) {
    case 'i':
      return std::to_string(row.TakeInteger());
    case 'r':
      return fmt::format("{}", row.TakeReal());
    default:  // NULL is an empty text, too
      return Quoted(row.TakeText());
  }
}

std::string Header(const Statement& rows) {
  std::string line;
  for (int i = 0; i < rows.columns(); ++i) {
    if (i > 0) line += ',';
    line += rows.ColumnName(i);
  }
  // As RFC 4180 has it; every reader takes this end of lines.
  return line + "\r\n";
}

}  // namespace

const std::vector<CsvTable>& CsvTables() {
  static const std::vector<CsvTable> tables = {
      {"run",
       "SELECT name, seed, generations, evaluations, random, plsc, ode, "
       "compiler, machine, experiment, scenario FROM run"},
      {"constants",
       "SELECT season.name AS season, physics.name, value, unit FROM physics "
       "JOIN season ON season.id = physics.season "
       "ORDER BY season.id, physics.name"},
      {"individuals",
       "SELECT individual.id, individual.name, generation, parent1, parent2, "
       "from_second, mutation, mutated_rule, senses, text AS genotype "
       "FROM individual JOIN genotype ON genotype.id = individual.id "
       "ORDER BY individual.id"},
      {"results",
       "SELECT result.* FROM result JOIN season ON season.name = "
       "result.season ORDER BY result.id, season.id"},
      {"generations", "SELECT number, best FROM generation ORDER BY number"},
      {"members",
       "SELECT generation, place, individual, count, survivor FROM member "
       "ORDER BY generation, place"},
      {"robots", "SELECT phenotype, body, brain FROM robot ORDER BY phenotype"},
  };
  return tables;
}

std::optional<std::string> WriteCsv(const std::string& run,
                                    const CsvTable& table, const Sink& sink) {
  Database database;
  if (auto failure = database.Open(run, Database::Mode::kRead)) return failure;
  if (auto failure = CheckIdentity(database)) return failure;
  Statement rows(database, table.sql);
  if (auto failure = database.TakeFailure()) return failure;
  if (auto failure = sink(Header(rows))) return failure;
  rows.With();
  while (rows.Next()) {
    std::string line;
    for (int i = 0; i < rows.columns(); ++i) {
      if (i > 0) line += ',';
      line += Cell(rows);
    }
    if (auto failure = sink(line + "\r\n")) return failure;
  }
  return database.TakeFailure();
}

}  // namespace plsc
