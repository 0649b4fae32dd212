#include "runtime/store/shared_cache.h"
#include "runtime/life/simulated.h"

#include <signal.h>
#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <string>

#include "runtime/evolve/simulated_frame.h"
#include "runtime/store/database.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {
namespace {

using test::Scratch;

Simulated Example() {
  Simulated example;
  example.inclination = 0.1 + 0.2;
  example.behaviour.is_valid = true;
  example.behaviour.displacement_velocity_hill = -0.0;
  example.state_hash = 0xfedcba9876543210;
  example.steps = 10000;
  return example;
}

TEST_CASE("A cache finds what any run added, bit for bit", "[shared_cache]") {
  const Scratch scratch;
  {
    SharedCache cache;
    REQUIRE_FALSE(cache.Open(scratch / "cache"));
    CHECK_FALSE(cache.Find({1, 2}));
    CHECK_FALSE(cache.Add({1, 2}, Example()));
    SharedCache other;  // at the same time
    REQUIRE_FALSE(other.Open(scratch / "cache"));
    CHECK(other.Find({1, 2}));
    CHECK_FALSE(other.Add({3, 4}, Example()));
    CHECK(cache.Find({3, 4}));
    CHECK_FALSE(cache.warning());
  }
  SharedCache cache;
  REQUIRE_FALSE(cache.Open(scratch / "cache"));
  const auto found = cache.Find({1, 2});
  REQUIRE(found);
  CHECK(found->inclination == 0.1 + 0.2);
  CHECK(std::signbit(found->behaviour.displacement_velocity_hill));
  CHECK(found->state_hash == 0xfedcba9876543210);
  CHECK(found->steps == 10000);
  CHECK_FALSE(cache.Find({2, 1}));
}

TEST_CASE("What another program simulated is not found", "[shared_cache]") {
  const Scratch scratch;
  SharedCache theirs;
  REQUIRE_FALSE(theirs.Open(scratch / "cache", "another engine"));
  CHECK_FALSE(theirs.Add({1, 2}, Example()));
  SharedCache ours;
  REQUIRE_FALSE(ours.Open(scratch / "cache"));
  CHECK_FALSE(ours.Find({1, 2}));
}

TEST_CASE("What is no cache is refused, and stays as it is", "[shared_cache]") {
  const Scratch scratch;
  std::ofstream(scratch / "cache") << "a text that was here before";
  SharedCache cache;
  CHECK(cache.Open(scratch / "cache"));
  std::ifstream file(scratch / "cache");
  std::string text;
  std::getline(file, text);
  CHECK(text == "a text that was here before");
  CHECK(SharedCache().Open("/no/such/folder/cache"));
  CHECK(SharedCache().Open("/tmp"));
}

TEST_CASE("A cache that cannot be written any more only warns",
          "[shared_cache]") {
  const Scratch scratch;
  SharedCache cache;
  REQUIRE_FALSE(cache.Open(scratch / "cache"));
  CHECK_FALSE(cache.Add({1, 2}, Example()));
  // Files may not grow from here on, as on a full disk.
  struct rlimit before {};
  getrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, SIG_IGN);
  const struct rlimit small = {1, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  CHECK_FALSE(cache.Add({3, 4}, Example()));
  setrlimit(RLIMIT_FSIZE, &before);
  REQUIRE(cache.warning());
  CHECK(cache.warning()->text.find("not used any more") != std::string::npos);
  CHECK_FALSE(cache.Find({1, 2}));
}

/// Of many values, so that each is told from the others.
Simulated Numbered(int number) {
  Simulated one = Example();
  one.begin = number;
  one.behaviour.head_balance = 1.0 / (number + 1);
  one.state_hash = static_cast<std::uint64_t>(number) * 0x9e3779b97f4a7c15;
  one.reason = std::string(static_cast<std::size_t>(number % 7), 'r');
  return one;
}

Key KeyOfNumber(int number) {
  return KeyOf("simulation " + std::to_string(number));
}

constexpr int kEntries = 12;
// By itself a cache hashes the program that opens it, which takes longer than
// all that is looked at here.
constexpr const char* kEngine = "an engine";

/// A cache's file with the entries 0 to kEntries - 1.
std::string FilledCache(const std::string& path,
                        const std::string& engine = ThisEngine()) {
  {
    SharedCache cache;
    REQUIRE_FALSE(cache.Open(path, engine));
    for (int i = 0; i < kEntries; ++i)
      REQUIRE_FALSE(cache.Add(KeyOfNumber(i), Numbered(i)));
  }
  return test::ReadBytes(path);
}

/// What a damaged cache is used for: whatever is found is what was added.
void UseDamaged(const std::string& path) {
  SharedCache cache;
  if (cache.Open(path, kEngine)) return;  // refused with a reason
  for (int i = 0; i < kEntries; ++i) {
    const std::string added = PackSimulated({Numbered(i)});
    const auto found = cache.Find(KeyOfNumber(i));
    if (found) {
      CHECK(PackSimulated({*found}) == added);
      continue;
    }
    // As a run does with what it has simulated then.
    CHECK_FALSE(cache.Add(KeyOfNumber(i), Numbered(i)));
    const auto again = cache.Find(KeyOfNumber(i));
    if (again) CHECK(PackSimulated({*again}) == added);
  }
}

std::string Flipped(std::string bytes, std::size_t bit) {
  char& byte = bytes[bit / 8];
  byte = static_cast<char>(byte ^ (1 << (bit % 8)));
  return bytes;
}

void FlipBits(std::size_t every) {
  const Scratch scratch;
  const std::string whole = FilledCache(scratch / "cache", kEngine);
  for (std::size_t bit = 0; bit < 8 * whole.size(); bit += every) {
    CAPTURE(bit);
    test::WriteBytes(scratch / "cache", Flipped(whole, bit));
    UseDamaged(scratch / "cache");
  }
}

TEST_CASE("A flipped bit never makes a wrong simulation", "[shared_cache]") {
  FlipBits(661);  // prime: every bit of a byte in turn
}

TEST_CASE("Nor does any other bit", "[shared_cache][slow]") {
  FlipBits(101);
}

TEST_CASE("A damaged entry is dropped, told and simulated anew",
          "[shared_cache]") {
  const Scratch scratch;
  std::string bytes = FilledCache(scratch / "cache");
  // The last digits of an entry's value, whatever they are.
  const std::size_t place = bytes.find(Hex(KeyOfNumber(3))) + 300;
  REQUIRE(place < bytes.size());
  bytes[place] = bytes[place] == '0' ? '1' : '0';
  test::WriteBytes(scratch / "cache", bytes);
  SharedCache cache;
  REQUIRE_FALSE(cache.Open(scratch / "cache"));
  CHECK(cache.Find(KeyOfNumber(2)));
  CHECK_FALSE(cache.warning());
  CHECK_FALSE(cache.Find(KeyOfNumber(3)));
  CHECK_FALSE(cache.Find(KeyOfNumber(3)));  // gone, so not told again
  REQUIRE(cache.warning());
  CHECK(*cache.warning() == "an entry of the cache '" + scratch / "cache" +
                                "' was damaged, dropped and simulated anew");
  CHECK_FALSE(cache.Add(KeyOfNumber(3), Numbered(3)));
  CHECK(PackSimulated({cache.Find(KeyOfNumber(3)).value()}) ==
        PackSimulated({Numbered(3)}));
}

TEST_CASE("An entry under another's key, or another program's, is no entry",
          "[shared_cache]") {
  const Scratch scratch;
  FilledCache(scratch / "cache");
  const auto change = [&](const std::string& sql) {
    Database database;
    REQUIRE_FALSE(database.Open(scratch / "cache", Database::Mode::kWrite));
    database.Run("PRAGMA foreign_keys = OFF;" + sql);
    REQUIRE_FALSE(database.TakeFailure());
  };
  change("DELETE FROM simulation WHERE key = '" + Hex(KeyOfNumber(1)) +
         "'; UPDATE simulation SET key = '" + Hex(KeyOfNumber(1)) +
         "' WHERE key = '" + Hex(KeyOfNumber(2)) +
         "'; INSERT INTO engine VALUES(9, 'theirs');"
         "UPDATE simulation SET engine = 9 WHERE key = '" +
         Hex(KeyOfNumber(4)) + "'");
  SharedCache ours;
  REQUIRE_FALSE(ours.Open(scratch / "cache"));
  CHECK_FALSE(ours.Find(KeyOfNumber(1)));
  CHECK_FALSE(ours.Find(KeyOfNumber(4)));
  SharedCache theirs;
  REQUIRE_FALSE(theirs.Open(scratch / "cache", "theirs"));
  CHECK_FALSE(theirs.Find(KeyOfNumber(4)));
  CHECK(ours.Find(KeyOfNumber(5)));
}

TEST_CASE("A cache without checksums is refused with what to do",
          "[shared_cache]") {
  const Scratch scratch;
  FilledCache(scratch / "cache");
  const auto failure_of = [&](int format) {
    {
      Database database;
      REQUIRE_FALSE(database.Open(scratch / "cache", Database::Mode::kWrite));
      database.Run("PRAGMA user_version = " + std::to_string(format));
      REQUIRE_FALSE(database.TakeFailure());
    }
    const std::string before = test::ReadBytes(scratch / "cache");
    const std::string failure =
        SharedCache().Open(scratch / "cache").value_or("").text;
    CHECK(test::ReadBytes(scratch / "cache") == before);
    return failure;
  };
  CHECK(failure_of(1).find("delete it, or name another file") !=
        std::string::npos);
  CHECK(failure_of(3).find("made by a newer plsc") != std::string::npos);
}

/// What came of a run, to be compared.
std::string ResultsOf(SimulationCache* cache) {
  test::Recorder recorder;
  EvolveOptions options;
  options.jobs = 1;
  options.simulate = test::Look;
  options.observers = {&recorder};
  if (cache != nullptr) options.caches = {cache};
  REQUIRE(Evolve(test::SmallExperiment(), options).failure.empty());
  std::string text;
  for (const auto& evidence : recorder.evidence)
    for (const SeasonEvidence& season : evidence)
      text += Hex(season.simulation) + PackSimulated({season.simulated});
  return text;
}

TEST_CASE("A run with a damaged cache ends as one without a cache",
          "[shared_cache]") {
  const Scratch scratch;
  const std::string expected = ResultsOf(nullptr);
  {
    SharedCache cache;
    REQUIRE_FALSE(cache.Open(scratch / "cache"));
    REQUIRE(ResultsOf(&cache) == expected);
  }
  const std::string whole = test::ReadBytes(scratch / "cache");
  int told = 0;
  // Bits spread over the file, each time hundreds of them in its entries.
  for (std::size_t first = 0; first < 12; ++first) {
    CAPTURE(first);
    std::string bytes = whole;
    for (std::size_t bit = 8 * 12288 + 311 * first; bit < 8 * bytes.size();
         bit += 8 * (900 + 31 * first))
      bytes = Flipped(std::move(bytes), bit);
    test::WriteBytes(scratch / "cache", bytes);
    SharedCache cache;
    if (cache.Open(scratch / "cache")) continue;
    CHECK(ResultsOf(&cache) == expected);
    told += cache.warning() ? 1 : 0;
  }
  CHECK(told > 0);
}

}  // namespace
}  // namespace plsc
