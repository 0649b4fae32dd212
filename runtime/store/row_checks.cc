// A row that is there is held to its checksum. A row that is not there is
// harder: it may be missing by right, because the run has not come so far, or
// by damage. How far the run is follows from two tables that must agree, which
// robots there must then be from the experiment (IdsBornIn), and where both
// leave it open (the generation that is under way) the table's pages are
// checked for rows that went with one.

#include "runtime/store/row_checks.h"

#include <fmt/format.h>

#include <map>

namespace plsc {

IdSpan IdsBornIn(const Experiment& experiment, int generation) {
  if (generation == 0) return {1, experiment.population};
  const int first =
      experiment.population + (generation - 1) * experiment.offspring + 1;
  return {first, first + experiment.offspring - 1};
}

RowChecks::RowChecks(Database& database)
    : database_(database),
      sums_(database),
      individual_(database,
                  "SELECT generation, checksum FROM individual WHERE id = ?"),
      evaluations_(database,
                   "SELECT season, checksum FROM evaluation "
                   "WHERE individual = ? ORDER BY season"),
      generation_(database, "SELECT checksum FROM generation WHERE number = ?"),
      // Two tables, so that damage to one page cannot hide it.
      completed_(database,
                 "SELECT (SELECT count(*) FROM generation), "
                 "(SELECT ifnull(max(number), -1) + 1 FROM generation), "
                 "(SELECT ifnull(max(generation), -1) + 1 FROM member)") {}

MaybeFailure RowChecks::Wrong(const std::string& what) {
  if (database_.has_failed()) return database_.TakeFailure();
  return fmt::format("'{}' is damaged: {}", database_.path(), what);
}

MaybeFailure RowChecks::Run() {
  Statement run(database_, "SELECT checksum FROM run");
  if (!run.With().Next()) return Wrong("it does not say what the run is");
  const std::int64_t sum = run.TakeInteger();
  run.Run();
  if (sum != sums_.OfRun()) return Wrong("what the run is cannot be trusted");
  return database_.TakeFailure();
}

MaybeFailure RowChecks::Birth(int id, std::optional<int> generation) {
  if (!individual_.With(id).Next())
    return Wrong(fmt::format("robot {} is missing", id));
  const int born = individual_.TakeInt();
  const std::int64_t sum = individual_.TakeInteger();
  individual_.Run();
  if (born != generation.value_or(born) || sum != sums_.OfIndividual(id))
    return Wrong(fmt::format("robot {} is not as it was born", id));
  return database_.TakeFailure();
}

MaybeFailure RowChecks::Evaluation(int id, int& seasons) {
  std::map<int, std::int64_t> sums;
  evaluations_.With(id);
  while (evaluations_.Next()) {
    const int season = evaluations_.TakeInt();
    sums[season] = evaluations_.TakeInteger();
  }
  seasons = static_cast<int>(sums.size());
  for (const auto& [season, sum] : sums)
    if (sum != sums_.OfEvaluation(id, season))
      return Wrong(
          fmt::format("the evaluation of robot {} is not what it was", id));
  return database_.TakeFailure();
}

MaybeFailure RowChecks::Generation(int number) {
  if (!generation_.With(number).Next())
    return Wrong(fmt::format("generation {} is missing", number));
  const std::int64_t sum = generation_.TakeInteger();
  generation_.Run();
  if (sum != sums_.OfGeneration(number))
    return Wrong(fmt::format("generation {} is not what it was", number));
  return database_.TakeFailure();
}

MaybeFailure RowChecks::Robot(const Experiment& experiment, int id) {
  const bool is_there = individual_.With(id).Next();
  individual_.Run();
  if (!is_there) {
    if (MaybeFailure failure = Unborn(experiment, id)) return failure;
    return fmt::format("'{}' has no robot {}", database_.path(), id);
  }
  if (MaybeFailure failure = Birth(id)) return failure;
  int seasons = 0;
  if (MaybeFailure failure = Evaluation(id, seasons)) return failure;
  if (seasons == 0) return Unevaluated(experiment, id);
  if (seasons != static_cast<int>(experiment.scenario.seasons.size()))
    return Wrong(fmt::format("robot {} lacks an evaluation", id));
  return std::nullopt;
}

MaybeFailure RowChecks::Completed(const Experiment& experiment) {
  if (!completed_.With().Next()) return database_.TakeFailure();
  const std::int64_t count = completed_.TakeInteger();
  const std::int64_t from_numbers = completed_.TakeInteger();
  const std::int64_t from_members = completed_.TakeInteger();
  completed_.Run();
  if (count != from_numbers || count != from_members ||
      count > experiment.generations)
    return Wrong("a generation is missing");
  return database_.TakeFailure();
}

MaybeFailure RowChecks::Unborn(const Experiment& experiment, int id) {
  if (MaybeFailure failure = Completed(experiment)) return failure;
  const int completed = static_cast<int>(
      SingleInteger(database_, "SELECT count(*) FROM generation"));
  const int next = completed < experiment.generations ? completed : -1;
  const int last =
      completed > 0 ? IdsBornIn(experiment, completed - 1).last : 0;
  const bool is_of_completed = id >= 1 && id <= last;
  // Of a generation under way all are born, or nobody.
  const IdSpan born = next < 0 ? IdSpan{} : IdsBornIn(experiment, next);
  const bool is_of_next = next >= 0 && id >= born.first && id <= born.last;
  if (is_of_completed ||
      (is_of_next &&
       SingleInteger(database_, "SELECT ifnull(max(id), 0) FROM individual") >
           last))
    return Wrong(fmt::format("robot {} is missing", id));
  return is_of_next ? Pages("individual") : database_.TakeFailure();
}

MaybeFailure RowChecks::Unevaluated(const Experiment& experiment, int id) {
  if (MaybeFailure failure = Completed(experiment)) return failure;
  const int completed = static_cast<int>(
      SingleInteger(database_, "SELECT count(*) FROM generation"));
  if (completed > 0 && id <= IdsBornIn(experiment, completed - 1).last)
    return Wrong(fmt::format("robot {} lacks an evaluation", id));
  return Pages("evaluation");
}

MaybeFailure RowChecks::Pages(const char* table) {
  Statement check(database_, fmt::format("PRAGMA integrity_check({})", table));
  if (!check.With().Next()) return database_.TakeFailure();
  const std::string said = check.TakeText();
  check.Run();
  if (said != "ok") return Wrong(said.substr(0, said.find('\n')));
  return database_.TakeFailure();
}

}  // namespace plsc
