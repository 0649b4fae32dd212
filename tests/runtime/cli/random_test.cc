#include <catch2/catch.hpp>

#include "tests/runtime/cli/run_plsc.h"

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
    for (int seed = 0; seed < 20; ++seed) {
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
