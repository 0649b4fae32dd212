// Bytes of a real store changed at random: whatever comes of it is a message
// or a store that can be loaded, never a crash, and nothing is written.

#include <catch2/catch.hpp>
#include <cstdint>
#include <string>

#include "runtime/store/result_dump.h"
#include "runtime/store/verify.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {

namespace {

constexpr std::uint64_t kSeed = 20260301;

/// SplitMix64: any even mixture will do.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : state_(seed) {}
  std::size_t Below(std::size_t count) {
    std::uint64_t word = (state_ += 0x9e3779b97f4a7c15);
    word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9;
    word = (word ^ (word >> 27)) * 0x94d049bb133111eb;
    return static_cast<std::size_t>((word ^ (word >> 31)) % count);
  }

 private:
  std::uint64_t state_;
};

/// One to eight bytes at random places, a stretch of garbage, or a cut.
std::string Damage(std::string bytes, Draw& draw) {
  const std::size_t kind = draw.Below(10);
  if (kind == 0) return bytes.substr(0, draw.Below(bytes.size()));
  if (kind == 1) {
    const std::size_t at = draw.Below(bytes.size());
    const std::size_t size = std::min(draw.Below(10000), bytes.size() - at);
    for (std::size_t i = 0; i < size; ++i)
      bytes[at + i] = static_cast<char>(draw.Below(256));
    return bytes;
  }
  // Half of them in the pages that say what is where.
  const std::size_t range = kind < 6 ? bytes.size() : 40000;
  for (std::size_t i = draw.Below(8) + 1; i > 0; --i) {
    char& byte = bytes[draw.Below(range)];
    byte = static_cast<char>(byte ^ (1 << draw.Below(8)));
  }
  return bytes;
}

void ReadAll(const std::string& path) {
  RunStore store;
  if (store.OpenForReading(path)) return;
  (void)store.Load();
  (void)store.Status();
  for (const int id : {1, 9, 20}) {
    (void)store.Find(id);
    (void)store.EvidenceOf(id);
    (void)store.Lineage(id, 3);
  }
}

void DamageOften(int times, std::uint64_t seed) {
  const test::Scratch scratch;
  const std::string path = scratch / "run";
  test::WriteRun(path, 3);
  const std::string whole = test::ReadBytes(path);
  const std::string dump = *DumpResults(path);
  Draw draw(seed);
  int refused = 0;
  for (int i = 0; i < times; ++i) {
    CAPTURE(seed, i);
    const std::string bytes = Damage(whole, draw);
    test::WriteBytes(path, bytes);
    RunStore store;
    const auto failure = store.Open(path);
    if (failure) {
      ++refused;
      CHECK(failure->text.find(path) != std::string::npos);
      CHECK(test::ReadBytes(path) == bytes);
      CHECK(scratch.Files() == std::vector<std::string>{"run"});
      // Even so it may be read as far as that goes.
      ReadAll(path);
      (void)DumpResults(path);
      continue;
    }
    // What was hit is nobody's: free space, or a counter of SQLite's.
    auto saved = store.Load();
    REQUIRE(saved);
    CHECK(saved->generations == 3);
    REQUIRE(store.Close() == std::nullopt);
    CHECK(*DumpResults(path) == dump);
  }
  // Most of a store is used.
  CHECK(refused > times / 2);
}

}  // namespace

TEST_CASE("A damaged store is refused, or nothing of it was damaged",
          "[damage]") {
  DamageOften(60, kSeed);
}

TEST_CASE("However often", "[damage][slow]") {
  DamageOften(400, kSeed + 1);
}

TEST_CASE("A damaged journal never makes a wrong store", "[damage]") {
  const test::Scratch scratch;
  const test::Recorder run = test::RecordRun(test::StoredExperiment());
  std::string file, journal;
  {
    RunStore store;
    REQUIRE(store.Create(scratch / "run", test::StoredExperiment()) ==
            std::nullopt);
    REQUIRE(test::Report(run, store, 0, 3) == "");
    file = test::ReadBytes(scratch / "run");
    journal = test::ReadBytes(scratch / "run-wal");
  }
  Draw draw(kSeed + 2);
  for (int i = 0; i < 40; ++i) {
    CAPTURE(i);
    const std::string path = scratch / std::to_string(i);
    test::WriteBytes(path, file);
    test::WriteBytes(path + "-wal", Damage(journal, draw));
    RunStore store;
    if (store.Open(path)) continue;
    auto saved = store.Load();
    REQUIRE(saved);
    CHECK(saved->generations <= 3);
  }
}

}  // namespace plsc
