#include "runtime/store/companions.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "runtime/store/result_dump.h"
#include "runtime/store/salvage.h"
#include "runtime/store/shared_cache.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {

namespace {

namespace fs = std::filesystem;
using test::ReadBytes;
using test::Scratch;
using test::WriteBytes;

Experiment WithSeed(std::uint64_t seed) {
  Experiment experiment = test::StoredExperiment();
  experiment.seed = seed;
  return experiment;
}

/// What a kill leaves of a run: the store and its journal.
void WriteKilled(const std::string& path, const Experiment& experiment,
                 int generations) {
  const Scratch scratch;
  RunStore store;
  REQUIRE(store.Create(scratch / "run", experiment) == std::nullopt);
  REQUIRE(test::Report(test::RecordRun(experiment), store, 0, generations) ==
          "");
  for (const char* end : {"", "-wal"})
    fs::copy_file((scratch / "run") + end, path + end,
                  fs::copy_options::overwrite_existing);
}

/// Everything in a folder: names, what links point to, bytes.
std::string Everything(const Scratch& scratch) {
  std::string all;
  for (const std::string& name : scratch.Files()) {
    const fs::path path = scratch.path() / name;
    all += name + ": ";
    if (fs::is_symlink(path))
      all += "-> " + fs::read_symlink(path).string();
    else if (fs::is_regular_file(path))
      all += ReadBytes(path);
    all += '\n';
  }
  return all;
}

struct Planted {
  const char* what;
  std::function<void(const Scratch&, const std::string& path)> plant;
};

const std::vector<Planted>& Plants() {
  static const std::vector<Planted> plants = {
      {"a text",
       [](const Scratch&, const std::string& path) {
         WriteBytes(path, "days of somebody's work\n");
       }},
      {"a link to a file",
       [](const Scratch& scratch, const std::string& path) {
         WriteBytes(scratch / "victim", "days of somebody's work\n");
         fs::create_symlink("victim", path);
       }},
      {"a link to nothing",
       [](const Scratch&, const std::string& path) {
         fs::create_symlink("nothing", path);
       }},
      {"a second name of a file",
       [](const Scratch& scratch, const std::string& path) {
         WriteBytes(scratch / "victim", "");
         fs::create_hard_link(scratch / "victim", path);
       }},
      {"a folder", [](const Scratch&,
                      const std::string& path) { fs::create_directory(path); }},
  };
  return plants;
}

const std::vector<std::string> kEnds = {"-journal", "-wal", "-shm"};

}  // namespace

TEST_CASE("Nothing is made beside what SQLite would take for its own",
          "[companions]") {
  for (const Planted& row : Plants())
    for (const std::string& end : kEnds) {
      CAPTURE(row.what, end);
      const Scratch scratch;
      const std::string path = scratch / "new";
      row.plant(scratch, path + end);
      const std::string before = Everything(scratch);
      const std::string name = "'" + path + end + "'";
      RunStore store;
      CHECK(store.Create(path, test::StoredExperiment())
                .value_or("")
                .text.find(name) == 0);
      SharedCache cache;
      CHECK(cache.Open(path).value_or("").text.find(name) == 0);
      CHECK((Everything(scratch) == before));
    }
}

TEST_CASE("Nothing is opened beside what is not its own", "[companions]") {
  for (const Planted& row : Plants())
    for (const std::string& end : kEnds) {
      CAPTURE(row.what, end);
      const Scratch scratch;
      const std::string path = scratch / "run";
      test::WriteRun(path, 1);
      row.plant(scratch, path + end);
      const std::string before = Everything(scratch);
      const std::string name = "'" + path + end + "'";
      RunStore store;
      Salvage salvage;
      CHECK(store.Open(path).value_or("").text.find(name) == 0);
      CHECK(store.OpenForReading(path).value_or("").text.find(name) == 0);
      CHECK(salvage.Open(path).value_or("").text.find(name) == 0);
      CHECK((Everything(scratch) == before));

      const Scratch other;
      const std::string cache = other / "cache";
      REQUIRE(SharedCache().Open(cache) == std::nullopt);
      row.plant(other, cache + end);
      const std::string cache_before = Everything(other);
      CHECK(SharedCache().Open(cache).value_or("").text.find("'" + cache + end +
                                                             "'") == 0);
      CHECK((Everything(other) == cache_before));
    }
}

TEST_CASE("A deleted run's journal is nobody else's", "[companions]") {
  const Scratch scratch;
  const std::string path = scratch / "run";
  WriteKilled(path, WithSeed(1), 2);
  fs::remove(path);
  const std::string before = Everything(scratch);
  RunStore store;
  // Of another run, or of the same.
  for (const std::uint64_t seed : {2u, 1u})
    CHECK(store.Create(path, WithSeed(seed))
              .value_or("")
              .text.find(path + "-wal") != std::string::npos);
  CHECK((Everything(scratch) == before));
}

TEST_CASE("A journal is not played back into another store", "[companions]") {
  // Even one of the same experiment and seed: pages of two files make a third.
  for (const std::uint64_t seed : {2u, 1u}) {
    CAPTURE(seed);
    const Scratch scratch;
    const std::string path = scratch / "run";
    WriteKilled(path, WithSeed(1), 2);
    WriteKilled(scratch / "other", WithSeed(seed), 1);
    fs::rename(scratch / "other", path);
    fs::remove(scratch / "other-wal");
    const std::string before = Everything(scratch);
    RunStore store;
    Salvage salvage;
    const std::string name = "'" + path + "-wal' is not of '" + path + "'";
    CHECK(store.Open(path).value_or("").text.find(name) == 0);
    CHECK(store.OpenForReading(path).value_or("").text.find(name) == 0);
    CHECK(salvage.Open(path).value_or("").text.find(name) == 0);
    CHECK((Everything(scratch) == before));
  }
}

TEST_CASE("A killed run's own journal is taken, by any name of the run",
          "[companions]") {
  const Scratch scratch;
  WriteKilled(scratch / "run", WithSeed(1), 2);
  fs::create_symlink("run", scratch / "link");
  for (const char* name : {"link", "run"}) {
    CAPTURE(name);
    RunStore store;
    REQUIRE(store.OpenForReading(scratch / name) == std::nullopt);
    CHECK(store.Load()->generations == 2);
  }
  RunStore store;
  REQUIRE(store.Open(scratch / "link") == std::nullopt);
  CHECK(store.Load()->generations == 2);
}

TEST_CASE("What SQLite leaves half made is its own", "[companions]") {
  const Scratch scratch;
  const std::string path = scratch / "run";
  test::WriteRun(path, 1);
  for (const std::string& journal :
       {std::string(), std::string("\x37\x7f", 2), std::string(500, '\0')})
    for (const std::size_t index : {0u, 3u, 4096u, 32768u}) {
      CAPTURE(journal.size(), index);
      WriteBytes(path + "-wal", journal);
      WriteBytes(path + "-shm", std::string(index, '\0'));
      CHECK(CheckCompanions(path) == std::nullopt);
      RunStore store;
      REQUIRE(store.Open(path) == std::nullopt);
      CHECK(store.Close() == std::nullopt);
      CHECK(scratch.Files() == std::vector<std::string>{"run"});
    }
  // But an index without a journal is what is left when that is lost.
  WriteBytes(path + "-shm", std::string(32768, '\0'));
  CHECK(CheckCompanions(path).value_or("").text.find(path + "-shm") == 1);
}

TEST_CASE("Databases are numbered by chance", "[companions]") {
  const std::int32_t first = DrawIdentity();
  CHECK(first > 0);
  // One in 2^31 would be the same.
  CHECK((DrawIdentity() != first || DrawIdentity() != first));
}

}  // namespace plsc
