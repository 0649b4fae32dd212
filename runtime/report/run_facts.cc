#include "runtime/report/run_facts.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/store/schema.h"

namespace plsc {

namespace {

WorkDone ReadWork(Database& database) {
  WorkDone work;
  Statement row(database,
                "SELECT started, ended, host, seconds, cpu_seconds, simulated, "
                "looked_up FROM session ORDER BY id");
  row.With();
  while (row.Next()) {
    ++work.sessions;
    const std::string started = row.TakeText();
    if (work.first.empty()) work.first = started;
    const std::string ended = row.TakeText();
    if (ended.empty())
      ++work.open_sessions;
    else
      work.last = ended;
    const std::string host = row.TakeText();
    if (std::find(work.hosts.begin(), work.hosts.end(), host) ==
        work.hosts.end())
      work.hosts.push_back(host);
    work.seconds += row.TakeOptional().value_or(0);
    work.cpu_seconds += row.TakeOptional().value_or(0);
    work.simulated += row.TakeInteger();  // NULL is 0
    work.looked_up += row.TakeInteger();
  }
  return work;
}

std::vector<StoredConstant> ReadConstants(Database& database) {
  std::vector<StoredConstant> constants;
  Statement row(database,
                "SELECT season.name, physics.name, value, unit FROM physics "
                "JOIN season ON season.id = physics.season "
                "ORDER BY season.id, physics.name");
  row.With();
  while (row.Next()) {
    StoredConstant constant;
    constant.season = row.TakeText();
    constant.name = row.TakeText();
    constant.value =
        row.Type() == 'r' ? fmt::format("{}", row.TakeReal()) : row.TakeText();
    constant.unit = row.TakeText();
    constants.push_back(std::move(constant));
  }
  return constants;
}

}  // namespace

RunFacts ReadFacts(Database& database) {
  RunFacts facts;
  facts.schema = SchemaOf(database);
  {
    Statement row(database,
                  "SELECT name, seed, plsc, ode, compiler, machine, results, "
                  "generations, evaluations FROM run");
    if (row.With().Next()) {
      facts.name = row.TakeText();
      facts.seed = row.TakeText();
      facts.versions.plsc = row.TakeText();
      facts.versions.ode = row.TakeText();
      facts.versions.compiler = row.TakeText();
      facts.versions.machine = row.TakeText();
      facts.versions.results = row.TakeInt();
      facts.planned_generations = row.TakeInt();
      facts.planned_evaluations = row.TakeInteger();
    }
    row.Run();
  }
  {
    Statement row(database,
                  "SELECT (SELECT count(*) FROM evaluation WHERE season = 1), "
                  "(SELECT best FROM generation ORDER BY number DESC LIMIT 1)");
    if (row.With().Next()) {
      facts.evaluations = row.TakeInteger();
      facts.best = row.TakeInt();
    }
    row.Run();
  }
  facts.work = ReadWork(database);
  facts.constants = ReadConstants(database);
  return facts;
}

}  // namespace plsc
