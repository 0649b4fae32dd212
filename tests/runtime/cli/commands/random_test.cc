#include <catch2/catch.hpp>
#include <set>

#include "tests/runtime/cli/run_plsc.h"

#include "tests/sanitizer.h"

namespace plsc {
namespace {

using test::RunPlsc;

TEST_CASE("a random genotype is a function of its seed", "[random]") {
  const auto one = RunPlsc({"random", "--seed", "1"});
  CHECK(one.exit == 0);
  CHECK(RunPlsc({"random", "--seed", "1"}).out == one.out);
  CHECK(RunPlsc({"random", "--seed", "2"}).out != one.out);
  CHECK(RunPlsc({"random", "--seed", "18446744073709551615"}).exit == 0);
}

TEST_CASE("a random genotype is correct and canonical", "[random]") {
  const std::vector<std::vector<std::string>> settings = {
      {},
      {"--encoding", "baseline"},
      {"--states", "inclined,hot", "--max-terms", "3", "--max-rules", "4"},
      {"--max-groups", "1"},
  };
  for (const auto& options : settings)
    for (int seed = 0; seed < test::Sampled(20); ++seed) {
      std::vector<std::string> arguments{"random", "--seed",
                                         std::to_string(seed)};
      arguments.insert(arguments.end(), options.begin(), options.end());
      const auto ran = RunPlsc(arguments);
      REQUIRE(ran.exit == 0);
      CHECK(RunPlsc({"check", "-"}, ran.out).exit == 0);
      CHECK(RunPlsc({"fmt", "-"}, ran.out).out == ran.out);
    }
}

TEST_CASE("a baseline genotype senses nothing", "[random]") {
  const auto ran = RunPlsc({"random", "--seed", "3", "--encoding", "baseline"});
  CHECK(ran.out.find("sense") == std::string::npos);
  CHECK(ran.out.find(" if ") == std::string::npos);
}

TEST_CASE("random draws several genotypes into one file", "[random]") {
  const auto one = RunPlsc({"random", "--seed", "7"});
  const auto three = RunPlsc({"random", "--seed", "7", "--count", "3"});
  REQUIRE(three.exit == 0);
  CHECK(RunPlsc({"check", "-"}, three.out).exit == 0);
  CHECK(RunPlsc({"random", "--seed", "7", "--count", "1"}).out == one.out);
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("three.pls", three.out);
  std::set<std::string> hashes;
  for (const char* name : {"random_7_1", "random_7_2", "random_7_3"})
    hashes.insert(RunPlsc({"hash", file + "#" + name}).out.substr(0, 32));
  CHECK(hashes.size() == 3);
  CHECK(hashes.contains(RunPlsc({"hash", "-"}, one.out).out.substr(0, 32)));
}

/// Each robot of generation 0 of a run, as it is stored.
void CheckBeginsWith(const std::string& experiment,
                     const std::vector<std::string>& seed, int population) {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("e.yaml", experiment);
  std::vector<std::string> evolve = {"evolve", file, "-o", folder / "r.sqlite",
                                     "--quiet"};
  evolve.insert(evolve.end(), seed.begin(), seed.end());
  REQUIRE(RunPlsc(evolve).exit == 0);
  std::vector<std::string> random = {"random", "--experiment", file};
  random.insert(random.end(), seed.begin(), seed.end());
  const auto drawn = RunPlsc(random);
  REQUIRE(drawn.exit == 0);
  std::string stored;
  for (int id = 1; id <= population; ++id) {
    const std::string text =
        RunPlsc({"show", folder / "r.sqlite", std::to_string(id), "--genotype"})
            .out;
    stored += stored.empty() ? text : text.substr(text.find('\n') + 1);
  }
  CHECK(drawn.out == stored);
}

TEST_CASE("random draws the population that a run begins with", "[random]") {
  const std::string seasons =
      "scenario:\n  seasons: [{terrain: flat, duration: 0.2 s, senses: {hot: "
      "True, dry: 0.5}}]\n";
  const std::string small =
      "plsc_experiment: 1\nseed: 12\npopulation: 4\noffspring: 1\n"
      "generations: 1\n" +
      seasons;
  CheckBeginsWith(small, {}, 4);
  CheckBeginsWith(small, {"--seed", "18446744073709551615"}, 4);
  CheckBeginsWith(small +
                      "encoding: baseline\nmax_modules: 5\nmax_groups: 2\n"
                      "groups_per_rule: True\nrobots: bug\n",
                  {}, 4);
  CheckBeginsWith(small +
                      "states: [inclined, hot]\nmax_rules: 3\n"
                      "max_terms: 4\nmin_initial_terms: 0\n"
                      "iterations: 2\nmove_to_new: True\n",
                  {}, 4);
}

TEST_CASE("random says what does not go together", "[random]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write(
      "e.yaml", "plsc_experiment: 1\npopulation: 4\noffspring: 1\n");
  const auto two = RunPlsc({"random", "--experiment", file, "--count", "2"});
  CHECK(two.exit == 0);
  CHECK(RunPlsc({"random", "--experiment", file}).out.find(two.out) == 0);
  const auto five = RunPlsc({"random", "--experiment", file, "--count", "5"});
  CHECK(five.exit == 2);
  CHECK(five.err.find("a population of 4") != std::string::npos);
  CHECK(RunPlsc({"random"}).exit == 2);
  CHECK(RunPlsc({"random", "--count", "2"}).exit == 2);
  CHECK(RunPlsc({"random", "--seed", "1", "--count", "0"}).exit == 2);
  CHECK(RunPlsc({"random", "--experiment", file, "--max-rules", "3"}).exit ==
        2);
  CHECK(RunPlsc({"random", "--experiment", folder / "none.yaml"}).exit == 1);
}

TEST_CASE("random overwrites nothing", "[random]") {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.pls";
  REQUIRE(RunPlsc({"random", "--seed", "1", "-o", file}).exit == 0);
  const std::string text = test::ReadFile(file);
  const auto again = RunPlsc({"random", "--seed", "2", "-o", file});
  CHECK(again.exit == 1);
  CHECK(again.err.find("exists") != std::string::npos);
  CHECK(test::ReadFile(file) == text);
  CHECK(RunPlsc({"random", "--seed", "1", "-o", folder / "no/a.pls"}).exit ==
        1);
}

TEST_CASE("a state that is no name is a usage error", "[random]") {
  for (const char* states : {"2nd", "rule", "hot,hot", "a b"}) {
    INFO(states);
    const auto ran = RunPlsc({"random", "--seed", "1", "--states", states});
    CHECK(ran.exit == 2);
    CHECK(ran.out.empty());
  }
}

}  // namespace
}  // namespace plsc
