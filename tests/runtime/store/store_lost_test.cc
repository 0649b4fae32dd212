// Stores that are deleted, moved or replaced while a run writes them, and those
// that are given up.

#include <catch2/catch.hpp>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "runtime/store/result_dump.h"
#include "runtime/store/run_store.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {

namespace {

namespace fs = std::filesystem;
using test::Scratch;
using LostFiles = std::vector<std::string>;

struct Loss {
  const char* what;
  std::function<void(const Scratch&)> lose;
  const char* lost;  ///< the file that is named
  LostFiles files;   ///< that are left in the end
};

const std::vector<Loss>& Losses() {
  const auto rename = [](const Scratch& scratch, const char* a, const char* b) {
    fs::rename(scratch / a, scratch / b);
  };
  static const std::vector<Loss> losses = {
      {"deleted", [](const Scratch& s) { fs::remove(s / "run"); }, "run", {}},
      {"moved",
       [=](const Scratch& s) { rename(s, "run", "moved"); },
       "run",
       {"moved"}},
      {"replaced",
       [=](const Scratch& s) {
         test::WriteRun(s / "other", 2);
         rename(s, "other", "run");
       },
       "run",
       {"run"}},
      {"replaced, journal and all",
       [](const Scratch& s) {
         for (const char* end : {"", "-wal", "-shm"}) {
           fs::remove((s / "run") + end);
           test::WriteBytes((s / "run") + end, "another's");
         }
       },
       "run",
       {"run", "run-shm", "run-wal"}},
      {"its journal deleted",
       [](const Scratch& s) { fs::remove(s / "run-wal"); },
       "run-wal",
       {"run"}},
      {"its journal replaced",
       [](const Scratch& s) {
         fs::remove(s / "run-wal");
         test::WriteBytes(s / "run-wal", "another's");
       },
       "run-wal",
       {"run", "run-wal"}},
  };
  return losses;
}

}  // namespace

TEST_CASE("A store that is lost is noticed at the next write", "[store_lost]") {
  const test::Recorder run = test::RecordRun(test::StoredExperiment());
  std::vector<Individual> born;
  for (const int id : run.births[1])
    born.push_back(run.individuals[static_cast<std::size_t>(id - 1)]);
  for (const Loss& row : Losses()) {
    CAPTURE(row.what);
    const Scratch scratch;
    RunStore store;
    REQUIRE(store.Create(scratch / "run", test::StoredExperiment()) ==
            std::nullopt);
    REQUIRE(test::Report(run, store, 0, 1) == "");
    CHECK_FALSE(store.is_lost());
    row.lose(scratch);
    const auto all = [&] {
      std::string bytes;
      for (const std::string& name : row.files)
        bytes += test::ReadBytes(scratch / name);
      return bytes;
    };
    const std::string theirs = all();
    const std::string told = "'" + (scratch / row.lost) +
                             "' was deleted, moved or replaced while it was "
                             "written to";
    CHECK(store.OnBirths(born, [] { return false; }) == told);
    CHECK(store.OnEvaluated(run.individuals[0], run.evidence[0]) == told);
    CHECK(store.OnGeneration(run.generations[1]) == told);
    CHECK(store.is_lost());
    CHECK(store.Close() == told);
    CHECK(scratch.Files() == row.files);
    // What is there instead is as it was.
    if (std::string(row.what).starts_with("replaced")) CHECK((all() == theirs));
  }
}

TEST_CASE("A store that was moved is whole where it is", "[store_lost]") {
  const Scratch scratch;
  const test::Recorder run = test::RecordRun(test::StoredExperiment());
  {
    RunStore store;
    REQUIRE(store.Create(scratch / "run", test::StoredExperiment()) ==
            std::nullopt);
    REQUIRE(test::Report(run, store, 0, 2) == "");
    fs::rename(scratch / "run", scratch / "moved");
    CHECK(store.Close());
  }
  test::WriteRun(scratch / "straight", 2);
  CHECK(*DumpResults(scratch / "moved") == *DumpResults(scratch / "straight"));
  RunStore store;
  REQUIRE(store.Open(scratch / "moved") == std::nullopt);
  CHECK(store.Load()->generations == 2);
}

TEST_CASE("Of a new store that is given up nothing is left", "[store_lost]") {
  const Scratch scratch;
  RunStore store;
  REQUIRE(store.Create(scratch / "run", test::StoredExperiment()) ==
          std::nullopt);
  store.Discard();
  CHECK(scratch.Files().empty());
  // What was there before stays.
  test::WriteRun(scratch / "run", 1);
  const std::string dump = *DumpResults(scratch / "run");
  REQUIRE(store.Open(scratch / "run") == std::nullopt);
  store.Discard();
  CHECK(scratch.Files() == LostFiles{"run"});
  CHECK(*DumpResults(scratch / "run") == dump);
}

}  // namespace plsc
