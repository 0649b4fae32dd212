#include "runtime/relive/orders.h"

#include <catch2/catch.hpp>
#include <set>

#include "tests/runtime/store/stored_run.h"

namespace plsc {
namespace {

std::vector<int> Chosen(const char* text, int completed) {
  const auto choice = ParseGenerations(text);
  REQUIRE(choice);
  const auto chosen = choice->Of(completed);
  REQUIRE(chosen);
  return *chosen;
}

/// Robots 3 and 5, of which 5 has another phenotype in the second season.
ReliveSubjects TwoRobots() {
  ReliveSubjects subjects;
  subjects.run.seasons = {"flat", "hill"};
  subjects.generations = {{4, 5, {3, 5}}};
  subjects.robots[3] = {11, {Key{1, 1}, Key{1, 1}}};
  subjects.robots[5] = {12, {Key{1, 1}, Key{2, 2}}};
  return subjects;
}

RelivedSeason Lived(const LifeOf& of, int n) {
  RelivedSeason life;
  life.of = of;
  life.n = n;
  return life;
}

TEST_CASE("generations are chosen by words and numbers", "[relive]") {
  CHECK(Chosen("last", 7) == std::vector{6});
  CHECK(Chosen("all", 3) == std::vector{0, 1, 2});
  CHECK(Chosen("every 3", 9) == std::vector{0, 3, 6, 8});
  CHECK(Chosen("5,0,5", 6) == std::vector{0, 5});
}

TEST_CASE("what chooses no generation is told", "[relive]") {
  for (const char* text : {"", "first", "every", "every 0", "every x", "1,,2",
                           "-1", "1.5", "1, 2", "99999999999"}) {
    INFO(text);
    CHECK_FALSE(ParseGenerations(text));
  }
  const auto choice = ParseGenerations("3");
  REQUIRE(choice);
  CHECK(choice->Of(3).error().text ==
        "there is no generation 3: 3 are completed, from 0 to 2");
  CHECK(choice->Of(0).error().text ==
        "no generation is completed yet, so nobody survived");
}

TEST_CASE("each robot lives once before any lives twice", "[relive]") {
  ReliveRequest request;
  request.lives = 2;
  request.swaps = 1;
  request.is_engine_checked = true;
  std::vector<std::pair<LifeOf, int>> orders;
  for (const LifeOrder& order : MissingLives(TwoRobots(), request, {}))
    orders.emplace_back(order.of, order.n);
  const std::vector<std::pair<LifeOf, int>> expected = {
      {{3}, 1},
      {{5}, 1},
      {{3}, 2},
      {{5}, 2},
      {{5, false, 0, 1}, 1},  // only what differs is swapped
      {{5, false, 1, 0}, 1},
      {{5, true}, 1},  // the best
      {{5, true}, 2}};
  CHECK(orders == expected);
}

TEST_CASE("what was lived is not missing, but for deaths of workers",
          "[relive]") {
  ReliveRequest request;
  request.lives = 2;
  request.swaps = 1;
  std::vector<RelivedSeason> there = {
      Lived({3, false, 0, 0}, 1), Lived({3, false, 1, 1}, 1),
      Lived({5, false, 0, 0}, 2), Lived({5, false, 1, 1}, 2),
      Lived({5, false, 1, 0}, 1)};
  // Dead in one season, so all of that life is lived anew.
  there[3].outcome = Outcome::kWorkerDied;
  std::vector<std::pair<LifeOf, int>> orders;
  for (const LifeOrder& order : MissingLives(TwoRobots(), request, there))
    orders.emplace_back(order.of, order.n);
  const std::vector<std::pair<LifeOf, int>> expected = {
      {{5}, 1}, {{3}, 2}, {{5}, 2}, {{5, false, 0, 1}, 1}};
  CHECK(orders == expected);
}

TEST_CASE(
    "robots are swapped no more often than they live, and not in one life",
    "[relive]") {
  ReliveRequest request;
  request.lives = 1;
  request.swaps = 5;
  ReliveSubjects subjects = TwoRobots();
  CHECK(MissingLives(subjects, request, {}).size() == 2 + 2);
  request.swaps = 0;
  CHECK(MissingLives(subjects, request, {}).size() == 2);
  request.swaps = 5;
  subjects.is_swappable = false;
  CHECK(MissingLives(subjects, request, {}).size() == 2);
}

TEST_CASE("each other phenotype is tried once, where there are robots",
          "[relive]") {
  const Key none{};
  const Key a{1, 1};
  const Key b{2, 2};
  CHECK(OtherPhenotypes({a, b, b, none}, 0) == std::vector{1});
  CHECK(OtherPhenotypes({a, b, b, none}, 2) == std::vector{0});
  CHECK(OtherPhenotypes({a, b, b, none}, 3).empty());
  CHECK(OtherPhenotypes({a, a}, 0).empty());
}

TEST_CASE("survivors and the best robot of a stored run are its subjects",
          "[relive]") {
  const test::Scratch scratch;
  test::WriteRun(scratch / "run.sqlite");
  RunStore store;
  REQUIRE_FALSE(store.OpenForReading(scratch / "run.sqlite"));
  const auto last = ParseGenerations("last");
  const auto subjects = SubjectsOf(store, *last);
  REQUIRE(subjects);
  const int generation = store.Status()->generations - 1;
  const auto record = store.Generation(generation);
  REQUIRE(subjects->generations.size() == 1);
  CHECK(subjects->generations[0].generation == generation);
  CHECK(subjects->generations[0].survivors == record->survivors);
  CHECK(subjects->generations[0].best == record->best);
  std::set<int> ids(record->survivors.begin(), record->survivors.end());
  ids.insert(record->best);
  CHECK(subjects->robots.size() == ids.size());
  CHECK(subjects->Sums().size() == ids.size());
  for (const auto& [id, robot] : subjects->robots) {
    CHECK(ids.contains(id));
    CHECK(robot.checksum == *store.ChecksumOfBirth(id));
    CHECK(robot.phenotypes.size() == subjects->run.seasons.size());
  }
  const auto beyond = ParseGenerations("99");
  CHECK_FALSE(SubjectsOf(store, *beyond));
}

TEST_CASE("the other engine is the one that a run does not have", "[relive]") {
  Scenario scenario = test::StoredExperiment().scenario;
  REQUIRE_FALSE(SetEngine(scenario, EngineKind::kOde));
  CHECK(OtherEngine(scenario) == EngineKind::kArticulated);
  REQUIRE_FALSE(SetEngine(scenario, EngineKind::kArticulated));
  CHECK(OtherEngine(scenario) == EngineKind::kOde);
}

}  // namespace
}  // namespace plsc
