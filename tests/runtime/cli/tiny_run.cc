#include "tests/runtime/cli/tiny_run.h"

#include <cassert>
#include <catch2/catch.hpp>
#include <filesystem>

#include "runtime/store/checksum.h"
#include "runtime/store/database.h"

namespace plsc::test {

const char* const kTinyExperiment = R"(plsc_experiment: 1
name: tiny
population: 6
offspring: 6
generations: 3
scenario:
  seasons:
    - {name: flat, terrain: flat, duration: 1 s}
    - {name: hill, terrain: {tilted: 5 deg}, duration: 1 s}
)";

TinyRun::TinyRun() {
  const auto ran = RunPlsc({"evolve", folder_.Write("e.yaml", kTinyExperiment),
                            "-o", path(), "--quiet", "--format", "json"});
  assert(ran.exit == 0);
  summary_ = nlohmann::json::parse(ran.out);
}

const TinyRun& FinishedRun() {
  static const TinyRun run;
  return run;
}

namespace {

std::string ChangedCopy(const TemporaryFolder& folder, const std::string& sql,
                        bool has_right_checksums) {
  const std::string copy = folder / "copy.sqlite";
  std::filesystem::copy_file(FinishedRun().path(), copy);
  Database store;
  REQUIRE_FALSE(store.Open(copy, Database::Mode::kWrite));
  store.Run(sql);
  Statement changes(store, "SELECT total_changes()");
  CHECK((changes.With().Next() && changes.TakeInteger() > 0));
  changes.Run();
  if (has_right_checksums) {
    Checksums sums(store);
    Statement update(store,
                     "UPDATE evaluation SET checksum = ? "
                     "WHERE individual = ? AND season = ?");
    for (int id = 1; id <= 18; ++id)
      for (int season = 1; season <= 2; ++season)
        update.With(sums.OfEvaluation(id, season), id, season).Run();
    Statement run(store, "UPDATE run SET checksum = ?");
    run.With(sums.OfRun()).Run();
  }
  REQUIRE_FALSE(store.TakeFailure());
  return copy;
}

}  // namespace

std::string ChangedRun(const TemporaryFolder& folder, const std::string& sql) {
  return ChangedCopy(folder, sql, true);
}

std::string DamagedRun(const TemporaryFolder& folder, const std::string& sql) {
  return ChangedCopy(folder, sql, false);
}

}  // namespace plsc::test
