#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <ostream>
#include <span>
#include <utility>

#include "grammar/shown_line.h"
#include "runtime/cli/arguments/runs.h"
#include "runtime/cli/commands/replay_compare.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/cli/running/relive.h"
#include "runtime/store/schema.h"
#include "runtime/store/verify.h"
#include "runtime/text/json_dump.h"
#include "sim/results.h"

namespace plsc::cli {

namespace {

using Json = nlohmann::ordered_json;

void PrintText(const Replayed& replayed, std::ostream& out) {
  if (replayed.differences.empty()) {
    out << fmt::format("{}: {} values in {} seasons equal\n", replayed.id,
                       replayed.values, replayed.seasons);
    return;
  }
  out << fmt::format("{}: {} of {} values differ\n", replayed.id,
                     replayed.differences.size(), replayed.values);
  for (const Difference& one : replayed.differences)
    out << fmt::format("  season {}, {}: stored {}, now {}\n",
                       Escaped(one.season), one.name, Escaped(one.stored),
                       Escaped(one.now));
}

void PrintJson(const Replayed& replayed, std::ostream& out) {
  Json json;
  json["id"] = replayed.id;
  json["seasons"] = replayed.seasons;
  json["values"] = replayed.values;
  json["differences"] = Json::array();
  for (const Difference& one : replayed.differences)
    json["differences"].push_back({{"season", one.season},
                                   {"name", one.name},
                                   {"stored", one.stored},
                                   {"now", one.now}});
  out << DumpJson(json) << '\n';
}

struct Stored {
  Individual individual;
  std::vector<SeasonEvidence> evidence;
};

Expected<std::vector<Stored>, Failure> Load(RunStore& store,
                                            std::span<const int> ids) {
  std::vector<Stored> batch;
  for (const int id : ids) {
    Expected<Individual, Failure> one = store.FindFirstLife(id);
    if (!one) return one.error();
    if (one->evaluation.seasons.empty())
      return Failure(fmt::format("{} is not evaluated yet", id));
    Expected<std::vector<SeasonEvidence>, Failure> evidence =
        store.EvidenceOf(id);
    if (!evidence) return evidence.error();
    batch.push_back({std::move(*one), std::move(*evidence)});
  }
  return batch;
}

/// In the order of `batch`; empty if there are no workers any more.
std::vector<Replayed> CompareAll(const std::vector<Stored>& batch,
                                 bool is_same_arithmetic, Relive& relive) {
  std::vector<Individual> robots;
  robots.reserve(batch.size());
  for (const Stored& stored : batch) robots.push_back(stored.individual);
  const std::vector<EvaluatedLife> lives = relive.Live(std::move(robots));
  std::vector<Replayed> replayed;
  for (std::size_t i = 0; i < lives.size(); ++i)
    replayed.push_back(Compare(batch[i].individual, batch[i].evidence, lives[i],
                               is_same_arithmetic));
  return replayed;
}

/// Why numbers may have come out otherwise.
std::string ReasonOf(const Versions& versions) {
  const std::string by = VersionsText(versions);
  if (versions.results != kResults)
    return fmt::format(
        "differences are expected: {} made this run, and this program's "
        "arithmetic is {}; plsc {} repeats it",
        by, kResults, versions.plsc);
  if (versions.machine == kAnyMachine)
    return fmt::format(
        "the articulated engine comes to the same bits on every machine, so "
        "another version of plsc ({} began this run) may be why, or a defect",
        by);
  return fmt::format(
      "another version of plsc or of ODE ({} began this run), or another kind "
      "of processor, may be why",
      by);
}

Expected<std::vector<int>, Failure> ChosenIds(const ReplayCommand& command,
                                              RunStore& store) {
  return command.all ? EvaluatedIds(store) : IdsOf(store, command.individuals);
}

/// The survivors, unless others are named, by the engine that is asked for.
Exit ReplayByEngine(const ReplayCommand& command, RunStore& store, Io& io) {
  int generation = -1;
  Expected<std::vector<int>, Failure> ids = ChosenIds(command, store);
  if (!command.all && command.individuals.empty()) {
    Expected<Survivors, Failure> survivors = SurvivorsOf(store, SIZE_MAX);
    if (!survivors) return Complain(survivors.error(), io);
    generation = survivors->generation;
    ids = std::move(survivors->ids);
  }
  if (!ids) return Complain(ids.error(), io);
  Expected<EngineCheck, Failure> check =
      CheckByEngine(store, *ids, *command.engine, command.jobs);
  if (!check) return Complain(check.error(), io);
  check->generation = generation;
  if (command.format == OutputFormat::kJson)
    io.out << DumpJson(EngineCheckJson(*check)) << '\n';
  else
    io.out << EngineCheckText(*check);
  return Exit::kFine;
}

}  // namespace

Exit Run(const ReplayCommand& command, Io& io) {
  RunStore store;
  if (const auto failure = store.OpenForReading(command.run))
    return Complain(*failure, io);
  // Whoever is lost with a page would not be missed otherwise.
  if (command.all)
    if (const auto problem = Examine(command.run).problem)
      return Complain(*problem, io);
  const Versions& versions = store.versions();
  const bool is_same_arithmetic = versions.results == kResults;
  if (!is_same_arithmetic)
    io.err << fmt::format(
        "note: {} was made by other arithmetic (results {}, and of this "
        "program {}): differences expected\n",
        Escaped(command.run), versions.results, kResults);
  if (const auto missing = MissingMeasures(store.schema());
      !missing.empty() && !command.engine)
    io.err << fmt::format(
        "note: {} is a store of schema {}, without {}: these are not "
        "compared\n",
        Escaped(command.run), store.schema(), fmt::join(missing, ", "));
  if (command.engine) return ReplayByEngine(command, store, io);
  const Expected<std::vector<int>, Failure> ids = ChosenIds(command, store);
  if (!ids) return Complain(ids.error(), io);
  Relive relive(store.experiment(), command.jobs);
  // Enough for all workers, few enough to be seen going on.
  constexpr std::size_t kBatch = 50;
  std::size_t different = 0;
  std::span<const int> rest(*ids);
  while (!rest.empty()) {
    const auto now = rest.first(std::min(rest.size(), kBatch));
    rest = rest.subspan(now.size());
    const Expected<std::vector<Stored>, Failure> batch = Load(store, now);
    if (!batch) return Complain(batch.error(), io);
    const std::vector<Replayed> replayed =
        CompareAll(*batch, is_same_arithmetic, relive);
    if (replayed.empty()) return Complain(*relive.failure(), io);
    for (const Replayed& one : replayed) {
      different += one.differences.empty() ? 0 : 1;
      command.format == OutputFormat::kJson ? PrintJson(one, io.out)
                                            : PrintText(one, io.out);
    }
    io.out.flush();
  }
  if (different == 0) return Exit::kFine;
  io.err << fmt::format(
      "error: {} of {} robots came out otherwise\n"
      "= help: {}\n",
      different, ids->size(), ReasonOf(versions));
  return Exit::kBadInput;
}

}  // namespace plsc::cli
