// Final states of fixed robots, bit for bit: the same on every run, in any
// order and company, from any number of threads, and from builds of any
// optimisation (the file below is compared with by all of them). Workers that
// are processes: tests/runtime/evolve/golden_workers_test.cc.

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <random>
#include <set>
#include <thread>

#include "sim/machine_kind.h"
#include "tests/sim/golden_robots.h"
#include "tests/sim/random_robot.h"

namespace plsc {
namespace {

using test::GoldenLife;
using Hashes = std::vector<std::uint64_t>;

Hashes HashAll(const std::vector<GoldenLife>& lives) {
  Hashes hashes;
  for (const GoldenLife& life : lives) hashes.push_back(test::HashOf(life));
  return hashes;
}

Hashes HashInThreads(const std::vector<GoldenLife>& lives, int threads) {
  Hashes hashes(lives.size());
  std::atomic<std::size_t> next = 0;
  std::vector<std::thread> pool;
  for (int i = 0; i < threads; ++i)
    pool.emplace_back([&] {
      for (std::size_t life = next++; life < lives.size(); life = next++)
        hashes[life] = test::HashOf(lives[life]);
    });
  for (std::thread& thread : pool) thread.join();
  return hashes;
}

TEST_CASE("Final states are those on file", "[golden]") {
  const auto lives = test::GoldenLives();
  REQUIRE(lives.size() == 4 * test::kGoldenBodies);
  std::ifstream file(PLSC_SOURCE_DIR "/tests/data/state_hashes.json");
  const auto known = nlohmann::json::parse(file).at("states");
  const std::string kind = MachineKind();
  const Hashes hashes = HashAll(lives);
  nlohmann::ordered_json ours;
  for (std::size_t i = 0; i < lives.size(); ++i)
    ours[lives[i].name] = fmt::format("{:016x}", hashes[i]);
  if (!known.contains(kind)) {
    nlohmann::ordered_json filed;
    filed[kind] = ours;
    WARN(
        "no states on file for this kind of machine, so they were compared "
        "with each other alone; to add them to tests/data/state_hashes.json:\n"
        << filed.dump(1));
    return;
  }
  for (const GoldenLife& life : lives) {
    INFO(life.name << "; a change of results is marked RESULTS in "
                      "CHANGELOG.md, and the states are filed anew:\n"
                   << ours.dump(1));
    CHECK(known.at(kind).at(life.name).get<std::string>() ==
          ours.at(life.name).get<std::string>());
  }
}

TEST_CASE("Final states depend on nothing but the robot's own life",
          "[golden][slow]") {
  const auto lives = test::GoldenLives();
  const Hashes once = HashAll(lives);
  SECTION("each life has its own") {
    // Else the comparisons below would compare too little.
    CHECK(std::set<std::uint64_t>(once.begin(), once.end()).size() ==
          once.size());
  }
  SECTION("on another run") {
    CHECK(HashAll(lives) == once);
  }
  SECTION("in reverse order") {
    const std::vector<GoldenLife> reverse(lives.rbegin(), lives.rend());
    Hashes hashes = HashAll(reverse);
    std::reverse(hashes.begin(), hashes.end());
    CHECK(hashes == once);
  }
  SECTION("after 100 other simulations") {
    std::mt19937 random(7);  // any
    for (int i = 0; i < 100; ++i) {
      SimulationOptions options = test::GoldenOptions(i % 2 == 0, i % 4 < 2);
      options.duration = 0.2;
      const auto terrains = test::AllTerrains();
      (void)Simulate(RandomRobot(2 + i % 9, random),
                     terrains[static_cast<std::size_t>(i) % terrains.size()],
                     options);
    }
    CHECK(HashAll(lives) == once);
  }
  SECTION("from 1, 2 and 4 threads") {
    for (const int threads : {1, 2, 4}) {
      CAPTURE(threads);
      CHECK(HashInThreads(lives, threads) == once);
    }
  }
}

}  // namespace
}  // namespace plsc
