#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "grammar/number.h"
#include "runtime/develop/environment_json.h"
#include "runtime/store/database.h"
#include "runtime/store/export.h"
#include "runtime/store/names.h"
#include "runtime/store/schema.h"
#include "runtime/store/verify.h"
#include "runtime/text/csv_cell.h"

namespace plsc {

namespace {

/// {"hot":"False"} as {"hot":false}.
std::string TypedSenses(const std::string& text,
                        const std::vector<State>& states) {
  const auto senses = nlohmann::ordered_json::parse(text, nullptr, false);
  if (!senses.is_object()) return text;
  auto typed = nlohmann::ordered_json::object();
  for (const auto& [name, value] : senses.items())
    typed[name] = value.is_string()
                      ? SensedValueJson(name, value.get<std::string>(), states)
                      : value;
  return typed.dump(-1, ' ', false,
                    nlohmann::ordered_json::error_handler_t::replace);
}

std::string HeaderLine(const Statement& rows) {
  std::string line;
  for (int i = 0; i < rows.columns(); ++i) {
    if (i > 0) line += ',';
    line += rows.ColumnName(i);
  }
  // As RFC 4180 has it; every reader takes this end of lines.
  return line + "\r\n";
}

int NumberOf(const std::string& cell) {
  return ReadNumber<int>(cell).value;
}

}  // namespace

const std::vector<CsvTable>& CsvTables() {
  static const std::vector<CsvTable> tables = {
      {"run", CsvRows::kOfRun,
       "SELECT name, seed, generations, evaluations, random, plsc, ode, "
       "compiler, machine, results, experiment, scenario FROM run"},
      {"constants", CsvRows::kOfRun,
       "SELECT season.name AS season, physics.name, value, unit FROM physics "
       "JOIN season ON season.id = physics.season "
       "ORDER BY season.id, physics.name"},
      {"individuals", CsvRows::kOfBirths,
       "SELECT individual.id, individual.name, generation, parent1, parent2, "
       "from_second, mutation, mutated_rule, senses, text AS genotype "
       "FROM individual JOIN genotype ON genotype.id = individual.id "
       "ORDER BY individual.id"},
      {"results", CsvRows::kOfEvaluations,
       "SELECT result.* FROM result JOIN season ON season.name = "
       "result.season ORDER BY result.id, season.id"},
      {"trials", CsvRows::kOfEvaluations,
       "SELECT trial.individual AS id, season.name AS season, number, fitness, "
       "trial.outcome, trial.reason, lift, shift_x, shift_y, yaw, friction, "
       "lean, touch, touch_seed, motor, motor_seed, phenotype, simulation "
       "FROM trial JOIN season ON season.id = trial.season "
       "ORDER BY trial.individual, season.id, number"},
      {"generations", CsvRows::kOfGenerations,
       fmt::format("SELECT number, best, {} FROM generation ORDER BY number",
                   fmt::join(CensusColumns(), ", "))},
      {"members", CsvRows::kOfGenerations,
       "SELECT generation, place, individual, count, survivor FROM member "
       "ORDER BY generation, place"},
      {"robots", CsvRows::kOfRobots,
       "SELECT phenotype, body, brain FROM robot ORDER BY phenotype"},
  };
  return tables;
}

struct CsvExport::Parts {
  Database database;
  std::optional<Transaction> instant;
  std::vector<State> states;
  Health health;
  /// Phenotypes of whole evaluations; only where there are others.
  std::set<std::string> robots;

  bool IsWhole(CsvRows rows, const std::string& first) const;
  std::string Cell(Statement& row, const std::string& column) const;
  void FindRobots();
};

bool CsvExport::Parts::IsWhole(CsvRows rows, const std::string& first) const {
  const int number = NumberOf(first);
  switch (rows) {
    case CsvRows::kOfRun:
      return health.is_run_whole;
    case CsvRows::kOfBirths:
      return health.births.contains(number);
    case CsvRows::kOfEvaluations:  // the generation of birth is there, too
      return health.evaluations.contains(number) &&
             health.births.contains(number);
    case CsvRows::kOfGenerations:
      return health.generations.contains(number);
    case CsvRows::kOfRobots:
      return !health.problem || robots.contains(first);
  }
  return false;
}

std::string CsvExport::Parts::Cell(Statement& row,
                                   const std::string& column) const {
  switch (row.Type()) {
    case 'i':
      return std::to_string(row.TakeInteger());
    case 'r':
      return PrintPlainNumber(row.TakeReal());
    default:  // NULL is an empty text, too
      break;
  }
  const std::string text = row.TakeText();
  const bool is_senses = column == "sensed" || column == "senses";
  return CsvCell(is_senses ? TypedSenses(text, states) : text);
}

void CsvExport::Parts::FindRobots() {
  Statement rows(database,
                 "SELECT individual, phenotype FROM evaluation "
                 "WHERE phenotype IS NOT NULL");
  rows.With();
  while (rows.Next()) {
    const bool is_whole = health.evaluations.contains(rows.TakeInt());
    if (is_whole) robots.insert(rows.TakeText());
  }
  database.TakeFailure();  // what cannot be read is not there
}

CsvExport::CsvExport() : parts_(std::make_unique<Parts>()) {}

CsvExport::~CsvExport() = default;

MaybeFailure CsvExport::Open(const std::string& run) {
  Database& database = parts_->database;
  if (MaybeFailure failure = database.Open(run, Database::Mode::kRead))
    return failure;
  parts_->instant.emplace(database);
  if (MaybeFailure failure = CheckIdentity(database)) return failure;
  parts_->health = Examine(database);
  if (!parts_->health.is_run_whole) return parts_->health.problem;
  if (parts_->health.problem) parts_->FindRobots();
  Statement experiment(database, "SELECT experiment FROM run");
  if (experiment.With().Next())
    if (const auto parsed = ParseExperiment(Source(run, experiment.TakeText())))
      parts_->states = parsed->genotype.states;
  return database.TakeFailure();
}

const MaybeFailure& CsvExport::damage() const {
  return parts_->health.problem;
}

MaybeFailure CsvExport::Write(const CsvTable& table, const Sink& sink) {
  Database& database = parts_->database;
  Statement rows(database, table.sql);
  if (MaybeFailure failure = database.TakeFailure()) return failure;
  if (MaybeFailure failure = sink(HeaderLine(rows))) return failure;
  std::vector<std::string> columns;
  columns.reserve(static_cast<std::size_t>(rows.columns()));
  for (int i = 0; i < rows.columns(); ++i)
    columns.push_back(rows.ColumnName(i));
  rows.With();
  while (rows.Next()) {
    std::string line;
    std::string first;
    for (const std::string& column : columns) {
      std::string cell = parts_->Cell(rows, column);
      if (line.empty()) first = cell;
      line += (line.empty() ? "" : ",") + cell;
    }
    if (!parts_->IsWhole(table.rows, first)) continue;
    if (MaybeFailure failure = sink(line + "\r\n")) return failure;
  }
  return database.TakeFailure();
}

}  // namespace plsc
