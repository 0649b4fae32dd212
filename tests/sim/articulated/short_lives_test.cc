// Final states of the articulated engine, bit for bit: one set for all
// machines, and the same in any order, company and thread. Other builds:
// short_lives_program.cc.

#include "tests/sim/articulated/short_lives.h"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <set>
#include <thread>

namespace plsc {
namespace {

using LifeHashes = std::vector<std::uint64_t>;

LifeHashes HashesOfLives(const std::vector<test::ShortLife>& lives) {
  LifeHashes hashes;
  for (const test::ShortLife& life : lives)
    hashes.push_back(test::HashOf(life));
  return hashes;
}

TEST_CASE("Articulated lives end in the states on file", "[short_lives]") {
  std::ifstream file(PLSC_SOURCE_DIR "/tests/data/articulated_lives.txt");
  std::string line;
  for (const test::ShortLife& life : test::ShortLives()) {
    INFO(
        "a change of results is marked RESULTS in CHANGELOG.md; the target "
        "update_lives files the states anew");
    REQUIRE(std::getline(file, line));
    CHECK(line == fmt::format("{} {:016x}", life.name, test::HashOf(life)));
  }
  CHECK_FALSE(std::getline(file, line));
}

TEST_CASE("Articulated lives depend on nothing but themselves",
          "[short_lives][slow]") {
  const auto lives = test::ShortLives();
  const LifeHashes once = HashesOfLives(lives);
  SECTION("each has its own end") {
    CHECK(std::set<std::uint64_t>(once.begin(), once.end()).size() ==
          once.size());
  }
  SECTION("in reverse order, after 100 others") {
    const std::vector<test::ShortLife> reverse(lives.rbegin(), lives.rend());
    LifeHashes hashes = HashesOfLives(reverse);
    std::reverse(hashes.begin(), hashes.end());
    CHECK(hashes == once);
  }
  SECTION("in two threads") {
    LifeHashes first, second;
    std::thread a([&] { first = HashesOfLives(lives); });
    std::thread b([&] { second = HashesOfLives(lives); });
    a.join();
    b.join();
    CHECK(first == once);
    CHECK(second == once);
  }
}

}  // namespace
}  // namespace plsc
