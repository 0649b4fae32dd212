// What was written comes back as it was, every bit of it but the sign of 0: a
// run is gone on with from here, and would otherwise end elsewhere than one
// that was never stopped. A result is put together from the rows of evaluation,
// phenotype, body and simulation, which others share.
//
// A store may be damaged, or edited by hand, in ways that SQLite does not see.
// So no column is trusted to be what its type says: each reader has a flag
// (is_damaged) for what it did not understand, and the robot that it is about
// is told as a failure of the database. Readers read on to the end of the row
// all the same, because columns are taken in order.
//
// Queries are prepared once, and each is run to its end, even where one row is
// all there can be: an open one keeps others from writing.

#include "runtime/store/run_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compiler/compile.h"
#include "grammar/enum_names.h"
#include "runtime/store/names.h"
#include "runtime/store/packing.h"
#include "runtime/store/schema.h"

namespace plsc {

namespace {

std::string SimulatedColumns() {
  return fmt::format(
      "simulation.begin, simulation.inclination, simulation.outcome, "
      "simulation.reason, is_valid, {}, state_hash, steps, solver_warnings",
      fmt::join(BehaviourColumns(), ", "));
}

std::string ResultsSql() {
  return fmt::format(
      "SELECT season.name, profile, evaluation.begin, evaluation.inclination, "
      "sensed, sources, change, change_reason, evaluation.outcome, "
      "evaluation.reason, fitness, evaluation.phenotype IS NOT NULL, {}, {}, "
      "evaluation.simulation IS NOT NULL, {} FROM evaluation "
      "JOIN season ON season.id = evaluation.season "
      "LEFT JOIN phenotype ON phenotype.key = evaluation.phenotype "
      "LEFT JOIN body ON body.key = phenotype.body "
      "LEFT JOIN simulation ON simulation.key = evaluation.simulation "
      "WHERE individual = ? ORDER BY season.id",
      fmt::join(BodyColumns(), ", "), fmt::join(BrainColumns(), ", "),
      SimulatedColumns());
}

std::string EvidenceSql() {
  return fmt::format(
      "SELECT evaluation.phenotype, body.packed, phenotype.packed, "
      "evaluation.simulation, {} "
      "FROM evaluation "
      "LEFT JOIN phenotype ON phenotype.key = evaluation.phenotype "
      "LEFT JOIN body ON body.key = phenotype.body "
      "LEFT JOIN simulation ON simulation.key = evaluation.simulation "
      "WHERE individual = ? ORDER BY season",
      SimulatedColumns());
}

std::vector<double> TakeReals(Statement& row, std::size_t count) {
  std::vector<double> values(count);
  for (double& value : values) value = row.TakeReal();
  return values;
}

Key TakeKey(Statement& row, bool& is_damaged) {
  if (row.IsNull()) {
    row.TakeText();
    return {};
  }
  const auto key = KeyOfHex(row.TakeText());
  is_damaged = is_damaged || !key;
  return key.value_or(Key{});
}

/// What an enumerator's column says; the first one, and damaged, otherwise.
template <typename T>
T Known(std::optional<T> value, bool& is_damaged) {
  is_damaged = is_damaged || !value;
  return std::move(value).value_or(T{});
}

Simulated TakeSimulated(Statement& row, bool& is_damaged) {
  Simulated simulated;
  simulated.begin = row.TakeReal();
  simulated.inclination = row.TakeOptional();
  simulated.outcome = Known(ValueIn(kOutcomeNames, row.TakeText()), is_damaged);
  simulated.reason = row.TakeText();
  const bool is_valid = row.TakeInteger() != 0;
  const auto values = TakeReals(row, List(Behaviour{}).size());
  if (is_valid) simulated.behaviour = BehaviourOf(values);
  simulated.state_hash = Known(WordOfHex(row.TakeText()), is_damaged);
  simulated.steps = row.TakeInteger();
  simulated.solver_warnings = row.TakeInt();
  return simulated;
}

SeasonResult TakeResult(Statement& row, bool& is_damaged) {
  SeasonResult result;
  result.season = row.TakeText();
  result.profile = Known(ValueIn(kProfileNames, row.TakeText()), is_damaged);
  result.begin = row.TakeReal();
  result.inclination = row.TakeOptional();
  const std::string sensed = row.TakeText();
  result.sensed = Known(SensedOf(sensed, row.TakeText()), is_damaged);
  result.change = Known(ValueIn(kChangeNames, row.TakeText()), is_damaged);
  result.change_reason = row.TakeText();
  result.outcome = Known(ValueIn(kOutcomeNames, row.TakeText()), is_damaged);
  result.reason = row.TakeText();
  result.fitness = row.TakeOptional();
  const bool has_phenotype = row.TakeInteger() != 0;
  const auto body = TakeReals(row, List(BodyDescriptors{}).size());
  const auto brain = TakeReals(row, List(BrainDescriptors{}).size());
  if (has_phenotype) {
    result.body = BodyDescriptorsOf(body);
    result.brain = BrainDescriptorsOf(brain);
  }
  if (row.TakeInteger() != 0) {
    const Simulated simulated = TakeSimulated(row, is_damaged);
    result.behaviour = simulated.behaviour;
    result.state_hash = simulated.state_hash;
    result.steps = simulated.steps;
    result.solver_warnings = simulated.solver_warnings;
  }
  return result;
}

Heritage TakeHeritage(Statement& row, bool& is_damaged) {
  Heritage heritage;
  for (int i = 0; i < 2; ++i) {
    const bool is_parent = !row.IsNull();
    const int parent = row.TakeInt();
    if (is_parent) heritage.parents.push_back(parent);
  }
  heritage.from_second =
      Known(HeadsOf(row.TakeText(), *PlasticodingAlphabet()), is_damaged);
  const bool is_mutated = !row.IsNull();
  const std::string kind = row.TakeText();
  const std::int64_t rule = row.TakeInteger();
  if (is_mutated)
    heritage.mutation =
        Mutation{Known(ValueIn(kMutationNames, kind), is_damaged),
                 static_cast<std::size_t>(rule)};
  heritage.senses = Known(SensesOf(row.TakeText()), is_damaged);
  return heritage;
}

std::int64_t Single(Database& database, const char* sql) {
  Statement statement(database, sql);
  return statement.With().Next() ? statement.TakeInteger() : 0;
}

}  // namespace

RunReader::RunReader(Database& database)
    : database_(database),
      birth_(database,
             "SELECT generation, parent1, parent2, from_second, mutation, "
             "mutated_rule, senses, genotype.name, text "
             "FROM individual JOIN genotype USING (id) WHERE id = ?"),
      results_(database, ResultsSql()),
      simulation_(database, fmt::format("SELECT {} FROM simulation "
                                        "WHERE key = ?",
                                        SimulatedColumns())),
      evidence_(database, EvidenceSql()),
      fitnesses_(database,
                 "SELECT fitness FROM evaluation WHERE individual = ? "
                 "ORDER BY season"),
      generation_(database, "SELECT best FROM generation WHERE number = ?"),
      members_(database,
               "SELECT individual, count, survivor FROM member "
               "WHERE generation = ? ORDER BY place") {}

void RunReader::Damaged(const std::string& what) {
  database_.Fail(fmt::format("'{}' is damaged: {} cannot be read",
                             database_.path(), what));
}

std::optional<Birth> RunReader::FindBirth(int id) {
  if (!birth_.With(id).Next()) return std::nullopt;
  Birth birth;
  bool is_damaged = false;
  birth.generation = birth_.TakeInt();
  birth.heritage = TakeHeritage(birth_, is_damaged);
  birth.name = birth_.TakeText();
  birth.genotype = birth_.TakeText();
  birth_.Run();
  if (is_damaged) Damaged(fmt::format("the birth of robot {}", id));
  return birth;
}

std::optional<Simulated> RunReader::FindSimulation(const Key& key) {
  const std::string digits = Hex(key);
  if (!simulation_.With(digits).Next()) return std::nullopt;
  bool is_damaged = false;
  Simulated simulated = TakeSimulated(simulation_, is_damaged);
  simulation_.Run();
  if (is_damaged) {
    Damaged("the simulation " + digits);
    return std::nullopt;
  }
  return simulated;
}

Evaluation RunReader::FindEvaluation(int id) {
  Evaluation evaluation;
  bool is_damaged = false;
  results_.With(id);
  while (results_.Next())
    evaluation.seasons.push_back(TakeResult(results_, is_damaged));
  if (is_damaged) Damaged(fmt::format("the evaluation of robot {}", id));
  return evaluation;
}

Individual RunReader::FindIndividual(int id) {
  Individual one;
  one.id = id;
  std::optional<Birth> birth = FindBirth(id);
  if (!birth) {
    database_.Fail(fmt::format("'{}' has no robot {}", database_.path(), id));
    return one;
  }
  one.generation = birth->generation;
  one.heritage = std::move(birth->heritage);
  const Source source(birth->name, birth->genotype);
  CompileOptions options;
  // Mutations may draw what a later version would not write.
  options.allow_out_of_range = true;
  Result<Program> program = Compile(source, options);
  if (!program) {
    Damaged(fmt::format("the genotype of robot {}", id));
    return one;
  }
  one.genotype = std::move(program->genotype);
  one.evaluation = FindEvaluation(id);
  return one;
}

std::vector<SeasonEvidence> RunReader::FindEvidence(int id) {
  std::vector<SeasonEvidence> all;
  bool is_damaged = false;
  evidence_.With(id);
  while (evidence_.Next()) {
    SeasonEvidence evidence;
    evidence.phenotype = TakeKey(evidence_, is_damaged);
    evidence.body = Unpack(evidence_.TakeText());
    evidence.brain = Unpack(evidence_.TakeText());
    evidence.simulation = TakeKey(evidence_, is_damaged);
    if (evidence.simulation != Key{})
      evidence.simulated = TakeSimulated(evidence_, is_damaged);
    all.push_back(std::move(evidence));
  }
  if (is_damaged) Damaged(fmt::format("the evaluation of robot {}", id));
  return all;
}

std::vector<std::optional<double>> RunReader::FindFitnesses(int id) {
  std::vector<std::optional<double>> fitnesses;
  fitnesses_.With(id);
  while (fitnesses_.Next()) fitnesses.push_back(fitnesses_.TakeOptional());
  return fitnesses;
}

std::optional<GenerationRecord> RunReader::FindGeneration(int number) {
  if (!generation_.With(number).Next()) return std::nullopt;
  GenerationRecord record;
  record.generation = number;
  record.best = generation_.TakeInt();
  generation_.Run();
  std::map<std::int64_t, int> survivors;  // by rank
  members_.With(number);
  while (members_.Next()) {
    const int id = members_.TakeInt();
    record.pool.push_back(id);
    record.counts.push_back(members_.TakeInt());
    if (!members_.IsNull()) survivors[members_.TakeInteger()] = id;
  }
  for (const auto& [rank, id] : survivors) record.survivors.push_back(id);
  return record;
}

int RunReader::Generations() {
  return static_cast<int>(Single(database_, "SELECT count(*) FROM generation"));
}

std::int64_t RunReader::Evaluations() {
  return Single(database_, "SELECT count(*) FROM evaluation WHERE season = 1");
}

std::vector<int> RunReader::EvaluatedSince(int id) {
  Statement statement(database_,
                      "SELECT DISTINCT individual FROM evaluation "
                      "WHERE individual >= ? ORDER BY individual");
  std::vector<int> ids;
  statement.With(id);
  while (statement.Next()) ids.push_back(statement.TakeInt());
  return ids;
}

}  // namespace plsc
