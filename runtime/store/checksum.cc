// One sum for all rows that an event wrote, over the bytes of each value with
// its type and length, so that no two rows have the same bytes (TakeBytes). It
// is taken from the rows as the database gives them, by the same statement when
// they are written and when they are checked. Joins bring in what is stored
// once and used by many: damage to a shared body is damage to every evaluation
// that has it.

#include "runtime/store/checksum.h"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "runtime/store/schema.h"
#include "runtime/text/key.h"

namespace plsc {

namespace {

void AppendRows(Statement& statement, std::string& bytes) {
  while (statement.Next()) {
    for (int i = 0; i < statement.columns(); ++i)
      bytes += statement.TakeBytes();
    bytes += '\n';
  }
}

/// 64 bits of the content's key: what a disk does is no attack.
std::int64_t Of(const std::string& bytes) {
  return static_cast<std::int64_t>(KeyOf(bytes).low);
}

std::vector<std::string> GenerationColumns(int schema) {
  std::vector<std::string> columns = {"number", "best"};
  for (std::string& one : CensusColumns(schema))
    columns.push_back(std::move(one));
  return columns;
}

std::string EvaluationSql(int schema) {
  return fmt::format(
      "SELECT season.name, evaluation.profile, evaluation.begin, "
      "evaluation.inclination, sensed, sources, change, change_reason, "
      "evaluation.outcome, evaluation.reason, fitness, evaluation.phenotype, "
      "phenotype.body, body.packed, {}, phenotype.packed, {}, "
      "evaluation.simulation, "
      "simulation.begin, "
      "simulation.inclination, simulation.outcome, simulation.reason, "
      "is_valid, {}, state_hash, steps, solver_warnings "
      "FROM evaluation JOIN season ON season.id = evaluation.season "
      "LEFT JOIN phenotype ON phenotype.key = evaluation.phenotype "
      "LEFT JOIN body ON body.key = phenotype.body "
      "LEFT JOIN simulation ON simulation.key = evaluation.simulation "
      "WHERE individual = ? AND season = ?",
      fmt::join(BodyColumns(), ", "), fmt::join(BrainColumns(), ", "),
      fmt::join(BehaviourColumns(schema), ", "));
}

std::string TrialsSql(int schema) {
  return fmt::format(
      "SELECT number, trial.phenotype, body.packed, {}, phenotype.packed, {}, "
      "trial.simulation, simulation.begin, simulation.inclination, "
      "simulation.outcome, simulation.reason, is_valid, {}, state_hash, steps, "
      "solver_warnings, trial.outcome, trial.reason, fitness, lift, shift_x, "
      "shift_y, yaw, friction, lean, touch, touch_seed, motor, motor_seed "
      "FROM trial "
      "LEFT JOIN phenotype ON phenotype.key = trial.phenotype "
      "LEFT JOIN body ON body.key = phenotype.body "
      "LEFT JOIN simulation ON simulation.key = trial.simulation "
      "WHERE individual = ? AND season = ? ORDER BY number",
      fmt::join(BodyColumns(), ", "), fmt::join(BrainColumns(), ", "),
      fmt::join(BehaviourColumns(schema), ", "));
}

}  // namespace

Checksums::Checksums(Database& database)
    : run_(database,
           fmt::format("SELECT id, name, seed, generations, evaluations, "
                       "random, plsc, ode, compiler, machine, {}experiment, "
                       "scenario FROM run",
                       SchemaOf(database) < 2 ? "" : "results, ")),
      constants_(database,
                 "SELECT season.id, season.name, physics.name, value, unit "
                 "FROM season LEFT JOIN physics ON physics.season = season.id "
                 "ORDER BY season.id, physics.name"),
      individual_(database,
                  "SELECT id, generation, parent1, parent2, from_second, "
                  "mutation, mutated_rule, senses, genotype.name, text "
                  "FROM individual JOIN genotype USING (id) WHERE id = ?"),
      evaluation_(database, EvaluationSql(SchemaOf(database))),
      has_trials_(SchemaOf(database) >= 4),
      trials_(database, has_trials_ ? TrialsSql(SchemaOf(database))
                                    : std::string("SELECT 1")),
      generation_(
          database,
          fmt::format("SELECT {} FROM generation WHERE number = ?",
                      fmt::join(GenerationColumns(SchemaOf(database)), ", "))),
      members_(database,
               "SELECT place, individual, count, survivor FROM member "
               "WHERE generation = ? ORDER BY individual") {}

std::int64_t Checksums::OfRun() {
  std::string bytes;
  AppendRows(run_.With(), bytes);
  AppendRows(constants_.With(), bytes);
  return Of(bytes);
}

std::int64_t Checksums::OfIndividual(int id) {
  std::string bytes;
  AppendRows(individual_.With(id), bytes);
  return Of(bytes);
}

std::int64_t Checksums::OfEvaluation(int individual, int season) {
  std::string bytes;
  AppendRows(evaluation_.With(individual, season), bytes);
  if (has_trials_) AppendRows(trials_.With(individual, season), bytes);
  return Of(bytes);
}

std::int64_t Checksums::OfGeneration(int number) {
  std::string bytes;
  AppendRows(generation_.With(number), bytes);
  AppendRows(members_.With(number), bytes);
  return Of(bytes);
}

}  // namespace plsc
