// Each event of a run is one transaction: all births of a generation, one
// robot's evaluation, one generation's decision. A kill between two loses
// nothing, a kill within one leaves what was there before it, and whoever
// resumes finds one of these states and no other.
//
// What repeats is stored once, by content: headers and rules of genotypes (a
// child has nearly all of its rules from its parents), bodies and phenotypes
// and simulations by their keys. Births and simulations that are there already
// are compared with what would be written, and a difference ends the run: the
// same ones must come again when a run is resumed, and if they do not, program
// or machine have changed and the rest would be another run's.
//
// A row is written with checksum 0 first, and its checksum is made of what the
// database then gives back, not of what it was given: -0 is stored as 0 and
// what is no number as NULL, and a checksum of the values before would call
// every such row damaged. Comparisons treat -0 in the same way (BitsOf).
//
// 0.3 to 0.4 ms of CPU time a robot (evolve_bench); statements are prepared
// once.

#include "runtime/store/run_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "compiler/print.h"
#include "runtime/life/simulated.h"
#include "runtime/store/genotype_parts.h"
#include "runtime/store/names.h"
#include "runtime/store/packing.h"
#include "runtime/store/schema.h"

namespace plsc {

namespace {

std::string Insert(const std::string& table, std::vector<std::string> columns,
                   const char* conflict = "") {
  const std::vector<std::string> values(columns.size(), "?");
  return fmt::format("INSERT INTO {}({}) VALUES({}) {}", table,
                     fmt::join(columns, ", "), fmt::join(values, ", "),
                     conflict);
}

std::vector<std::string> Joined(std::vector<std::string> first,
                                const std::vector<std::string>& second,
                                const std::vector<std::string>& third = {}) {
  first.insert(first.end(), second.begin(), second.end());
  first.insert(first.end(), third.begin(), third.end());
  return first;
}

// -0 is stored as 0, so it must not count as another result.
std::uint64_t BitsOf(double value) {
  return std::bit_cast<std::uint64_t>(value == 0 ? 0 : value);
}

bool IsSame(double a, double b) {
  return BitsOf(a) == BitsOf(b);
}

bool IsSame(const std::optional<double>& a, const std::optional<double>& b) {
  return a.has_value() == b.has_value() && (!a || IsSame(*a, *b));
}

template <typename Descriptors>
bool IsSameList(const Descriptors& a, const Descriptors& b) {
  const auto first = List(a), second = List(b);
  for (std::size_t i = 0; i < first.size(); ++i)
    if (!IsSame(first[i].value, second[i].value)) return false;
  return true;
}

bool IsSame(const Behaviour& a, const Behaviour& b) {
  return a.is_valid == b.is_valid && IsSameList(a, b);
}

bool IsSame(const Simulated& a, const Simulated& b) {
  return IsSame(a.begin, b.begin) && IsSame(a.inclination, b.inclination) &&
         a.outcome == b.outcome && a.reason == b.reason &&
         IsSame(a.behaviour, b.behaviour) && a.state_hash == b.state_hash &&
         a.steps == b.steps && a.solver_warnings == b.solver_warnings;
}

bool IsSame(const Heritage& a, const Heritage& b) {
  return a.parents == b.parents && a.from_second == b.from_second &&
         a.mutation == b.mutation && a.senses == b.senses;
}

// Its result says nothing of the phenotype or the simulation, but of a process.
bool IsLost(const SeasonResult& result) {
  return result.outcome == Outcome::kWorkerDied;
}

bool HasSimulation(const SeasonResult& result, const SeasonEvidence& evidence) {
  return evidence.simulation != Key{} && !IsLost(result);
}

bool HasPhenotype(const SeasonEvidence& evidence) {
  return evidence.phenotype != Key{};
}

/// Whether all that is stored with the phenotype and the simulation is what
/// the result has. A result that says more could not be stored: readers take
/// what it measured from those rows, and it would come back as another.
bool Explains(const SeasonEvidence& evidence, const SeasonResult& result) {
  Simulated simulated;
  if (HasSimulation(result, evidence)) simulated = evidence.simulated;
  const bool is_simulation_same =
      IsSame(simulated.behaviour, result.behaviour) &&
      simulated.state_hash == result.state_hash &&
      simulated.steps == result.steps &&
      simulated.solver_warnings == result.solver_warnings;
  return is_simulation_same && (HasPhenotype(evidence) ||
                                (IsSameList(BodyDescriptors{}, result.body) &&
                                 IsSameList(BrainDescriptors{}, result.brain)));
}

std::optional<std::string> HexOf(const Key& key, bool is_there) {
  if (!is_there) return std::nullopt;
  return Hex(key);
}

// Finds a rule by an index of numbers instead of texts; the text is compared as
// well, so that equal hashes cost time and no rule.
std::int64_t HashOf(const std::string& text) {
  return static_cast<std::int64_t>(KeyOf(text).low);
}

template <typename T>
std::optional<T> At(const std::vector<T>& values, std::size_t i) {
  if (i >= values.size()) return std::nullopt;
  return values[i];
}

}  // namespace

RunWriter::RunWriter(Database& database, RunReader& reader,
                     const Experiment& experiment,
                     std::map<std::string, int> seasons)
    : database_(database),
      reader_(reader),
      seasons_(std::move(seasons)),
      checksums_(database),
      census_(database, experiment),
      header_(database, Insert("header", {"before_name", "after_name"})),
      find_header_(database,
                   "SELECT id FROM header "
                   "WHERE before_name = ? AND after_name = ?"),
      individual_(database,
                  Insert("individual",
                         {"id", "name", "generation", "parent1", "parent2",
                          "from_second", "mutation", "mutated_rule", "senses",
                          "header", "checksum"})),
      sum_individual_(database,
                      "UPDATE individual SET checksum = ? WHERE id = ?"),
      rule_(database, Insert("rule", {"hash", "text"})),
      find_rule_(database, "SELECT id FROM rule WHERE hash = ? AND text = ?"),
      genotype_rule_(database, Insert("genotype_rule",
                                      {"individual", "position", "rule"})),
      body_(database, Insert("body", Joined({"key", "packed"}, BodyColumns()),
                             "ON CONFLICT DO NOTHING")),
      find_phenotype_(database, "SELECT 1 FROM phenotype WHERE key = ?"),
      phenotype_(database, Insert("phenotype", Joined({"key", "body", "packed"},
                                                      BrainColumns()))),
      simulation_(database,
                  Insert("simulation",
                         Joined({"key", "begin", "inclination", "outcome",
                                 "reason", "is_valid"},
                                BehaviourColumns(),
                                {"state_hash", "steps", "solver_warnings"}))),
      evaluation_(
          database,
          Insert("evaluation", {"individual", "season", "phenotype",
                                "simulation", "profile", "begin", "inclination",
                                "sensed", "sources", "change", "change_reason",
                                "outcome", "reason", "fitness", "checksum"})),
      find_lost_(database,
                 "SELECT count(*) FROM evaluation WHERE individual = ? "
                 "AND outcome = 'worker_died'"),
      remove_(database, "DELETE FROM evaluation WHERE individual = ?"),
      trials_(database, true),
      sum_evaluation_(database,
                      "UPDATE evaluation SET checksum = ? "
                      "WHERE individual = ? AND season = ?"),
      generation_(database,
                  Insert("generation", Joined({"number", "best"},
                                              CensusColumns(), {"checksum"}))),
      sum_generation_(database,
                      "UPDATE generation SET checksum = ? WHERE number = ?"),
      member_(database, Insert("member", {"generation", "individual", "place",
                                          "count", "survivor"})) {}

MaybeFailure RunWriter::Births(const std::vector<Individual>& born,
                               const std::function<bool()>& should_stop) {
  Transaction transaction(database_);
  for (const Individual& one : born) {
    if (should_stop && should_stop()) return std::nullopt;
    const std::optional<Birth> stored = reader_.FindBirth(one.id);
    if (!stored) {
      AddIndividual(one);
    } else if (stored->generation != one.generation ||
               stored->name != one.genotype.name ||
               stored->genotype != Print(one.genotype) ||
               !IsSame(stored->heritage, one.heritage)) {
      database_.Fail(fmt::format(
          "robot {} of '{}' is born otherwise now than it was: the run was "
          "begun by another version of the program, or on another kind of "
          "machine",
          one.id, database_.path()));
    }
    if (database_.has_failed()) break;
  }
  return transaction.Commit();
}

void RunWriter::AddIndividual(const Individual& one) {
  const GenotypeParts parts =
      SplitGenotype(Print(one.genotype), one.genotype.name);
  const auto id_of = [](Statement& find, Statement& insert,
                        const auto&... key) {
    if (!find.With(key...).Next()) {
      insert.With(key...).Run();
      if (!find.With(key...).Next()) return std::int64_t{0};
    }
    const std::int64_t id = find.TakeInteger();
    find.Run();  // to its end, or the query stays open
    return id;
  };
  const Heritage& heritage = one.heritage;
  const std::int64_t header =
      id_of(find_header_, header_, parts.before_name, parts.after_name);
  std::optional<std::string> mutation;
  std::optional<std::int64_t> mutated_rule;
  if (heritage.mutation) {
    mutation = NameIn(kMutationNames, heritage.mutation->kind);
    mutated_rule = static_cast<std::int64_t>(heritage.mutation->rule);
  }
  individual_
      .With(one.id, one.genotype.name, one.generation, At(heritage.parents, 0),
            At(heritage.parents, 1),
            HeadsText(heritage.from_second, *one.genotype.alphabet), mutation,
            mutated_rule, SensesText(heritage.senses), header, 0)
      .Run();
  for (std::size_t i = 0; i < parts.rules.size(); ++i)
    genotype_rule_
        .With(one.id, static_cast<std::int64_t>(i),
              id_of(find_rule_, rule_, HashOf(parts.rules[i]), parts.rules[i]))
        .Run();
  sum_individual_.With(checksums_.OfIndividual(one.id), one.id).Run();
}

MaybeFailure RunWriter::Evaluated(const Individual& one,
                                  const std::vector<SeasonEvidence>& evidence) {
  Transaction transaction(database_);
  // A resumed run tries again what a worker died of; only such evaluations may
  // be replaced.
  const bool is_lost =
      find_lost_.With(one.id).Next() && find_lost_.TakeInteger() > 0;
  find_lost_.Run();
  if (is_lost) {
    remove_.With(one.id).Run();
    trials_.Remove(one.id);
  }
  const std::vector<SeasonResult>& results = one.evaluation.seasons;
  for (std::size_t i = 0; i < results.size(); ++i)
    AddSeason(one.id, results[i],
              i < evidence.size() ? evidence[i] : SeasonEvidence{});
  return transaction.Commit();
}

void RunWriter::AddSeason(int individual, const SeasonResult& result,
                          const SeasonEvidence& evidence) {
  const auto season = seasons_.find(result.season);
  if (season == seasons_.end() || !Explains(evidence, result)) {
    database_.Fail(fmt::format(
        "season '{}' of robot {} does not follow from what was simulated",
        result.season, individual));
    return;
  }
  const bool has_phenotype = HasPhenotype(evidence);
  const bool has_simulation = HasSimulation(result, evidence);
  if (has_phenotype) AddPhenotype(result, evidence);
  if (has_simulation) AddSimulation(evidence);
  for (const Trial& trial : evidence.trials) {
    if (HasPhenotype(trial.evidence))
      AddPhenotype(trial.result, trial.evidence);
    if (plsc::HasSimulation(trial)) AddSimulation(trial.evidence);
  }
  trials_.Add(individual, season->second, evidence.trials);
  evaluation_
      .With(individual, season->second,
            HexOf(evidence.phenotype, has_phenotype),
            HexOf(evidence.simulation, has_simulation),
            NameIn(kProfileNames, result.profile), result.begin,
            result.inclination, SensedText(result.sensed),
            SourcesText(result.sensed), NameIn(kChangeNames, result.change),
            result.change_reason, OutcomeName(result.outcome), result.reason,
            result.fitness, 0)
      .Run();
  sum_evaluation_
      .With(checksums_.OfEvaluation(individual, season->second), individual,
            season->second)
      .Run();
}

void RunWriter::AddPhenotype(const SeasonResult& result,
                             const SeasonEvidence& evidence) {
  const std::string key = Hex(evidence.phenotype);
  if (find_phenotype_.With(key).Next()) {
    find_phenotype_.Run();
    return;
  }
  // The body may be there with another brain, and then nothing is inserted.
  const std::string body = Hex(KeyOf(evidence.body));
  const std::string packed_body = Pack(evidence.body);
  body_.With(body, packed_body);
  for (const NamedValue& value : List(result.body)) body_.And(value.value);
  body_.Run();
  const std::string packed_brain = Pack(evidence.brain);
  phenotype_.With(key, body, packed_brain);
  for (const NamedValue& value : List(result.brain))
    phenotype_.And(value.value);
  phenotype_.Run();
}

void RunWriter::AddSimulation(const SeasonEvidence& evidence) {
  const Simulated& simulated = evidence.simulated;
  if (const auto stored = reader_.FindSimulation(evidence.simulation)) {
    if (!IsSame(*stored, simulated))
      database_.Fail(fmt::format(
          "the simulation {} ended otherwise now than it did before: '{}' was "
          "begun by another version of the program, or on another kind of "
          "machine",
          Hex(evidence.simulation), database_.path()));
    return;
  }
  const std::string key = Hex(evidence.simulation);
  const std::string hash = fmt::format("{:016x}", simulated.state_hash);
  simulation_.With(key, simulated.begin, simulated.inclination,
                   OutcomeName(simulated.outcome), simulated.reason,
                   simulated.behaviour.is_valid ? 1 : 0);
  for (const NamedValue& value : List(simulated.behaviour)) {
    if (simulated.behaviour.is_valid)
      simulation_.And(value.value);
    else
      simulation_.And(std::nullopt);
  }
  simulation_.And(hash).And(simulated.steps).And(simulated.solver_warnings);
  simulation_.Run();
}

// All of the pool, not only who survived: how selection went can be seen later.
MaybeFailure RunWriter::Completed(const GenerationRecord& record) {
  Transaction transaction(database_);
  // The order of survivors is part of what a run goes on from: tournaments draw
  // places in it.
  std::map<int, std::int64_t> ranks;
  for (const int id : record.survivors)
    ranks.emplace(id, static_cast<std::int64_t>(ranks.size()));
  generation_.With(record.generation, record.best);
  for (const std::int64_t count : List(CountSurvivors(record)))
    generation_.And(count);
  generation_.And(0).Run();
  for (std::size_t i = 0; i < record.pool.size(); ++i) {
    const auto rank = ranks.find(record.pool[i]);
    std::optional<std::int64_t> survivor;
    if (rank != ranks.end()) survivor = rank->second;
    member_
        .With(record.generation, record.pool[i], static_cast<std::int64_t>(i),
              record.counts[i], survivor)
        .Run();
  }
  sum_generation_
      .With(checksums_.OfGeneration(record.generation), record.generation)
      .Run();
  return transaction.Commit();
}

// A run that goes on has to pass what it completed before.
CensusCounts RunWriter::CountSurvivors(const GenerationRecord& record) {
  for (; counted_ < record.generation; ++counted_)
    if (const auto before = reader_.FindGeneration(counted_))
      census_.Pass(before->survivors);
  ++counted_;
  return census_.Count(record.survivors);
}

}  // namespace plsc
