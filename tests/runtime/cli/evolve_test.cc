// Real runs, small: few robots, seasons of a second.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using nlohmann::json;
using test::ReadFile;
using test::RunPlsc;

std::string Experiment(const char* encoding) {
  return std::string("plsc_experiment: 1\nname: tiny\nencoding: ") + encoding +
         R"(
population: 6
offspring: 6
generations: 3
scenario:
  name: short
  seasons:
    - {name: flat, terrain: flat, duration: 1 s, senses: {inclined: False}}
    - {name: hill, terrain: {tilted: 5 deg}, duration: 1 s,
       start_height: 10 cm, senses: {inclined: True}}
)";
}

TEST_CASE("evolve runs both encodings to the end", "[evolve]") {
  for (const char* encoding : {"plasticoding", "baseline"}) {
    INFO(encoding);
    const test::TemporaryFolder folder;
    const std::string file = folder.Write("e.yaml", Experiment(encoding));
    const auto ran = RunPlsc({"evolve", file, "-o", folder / "run", "--jobs",
                              "2", "--format", "json"});
    INFO(ran.err);
    REQUIRE(ran.exit == 0);
    const json summary = json::parse(ran.out);
    CHECK(summary["finished"] == true);
    CHECK(summary["generations"] == 3);
    CHECK(summary["evaluations"] == 18);
    const std::string best = summary["best"]["genotype"];
    CHECK(best == ReadFile(folder.path() / "run" / "best.pls"));
    CHECK(RunPlsc({"check", "-"}, best).exit == 0);
    CHECK(ran.err.find("generation 3/3") != std::string::npos);
  }
}

TEST_CASE("evolve prints the best robot's genotype and bodies", "[evolve]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("e.yaml", Experiment("plasticoding"));
  const auto ran = RunPlsc({"evolve", file, "-o", folder / "run", "--quiet"});
  REQUIRE(ran.exit == 0);
  CHECK(ran.err.empty());
  CHECK(ran.out.find("best robot: robot_") == 0);
  CHECK(ran.out.find("plsc 1\n") != std::string::npos);
  CHECK(ran.out.find("season flat: speed") != std::string::npos);
  CHECK(ran.out.find("│ C 1 │") != std::string::npos);
}

TEST_CASE("the number of workers changes no byte of a run", "[evolve]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("e.yaml", Experiment("plasticoding"));
  for (const char* jobs : {"1", "2", "3"})
    REQUIRE(RunPlsc({"evolve", file, "-o", folder / jobs, "--jobs", jobs,
                     "--quiet"})
                .exit == 0);
  for (const char* name :
       {"run.json", "individuals.jsonl", "generations.jsonl", "best.pls"}) {
    INFO(name);
    const std::string one = ReadFile(folder.path() / "1" / name);
    CHECK_FALSE(one.empty());
    CHECK(ReadFile(folder.path() / "2" / name) == one);
    CHECK(ReadFile(folder.path() / "3" / name) == one);
  }
  SECTION("another seed is another run") {
    REQUIRE(RunPlsc({"evolve", file, "-o", folder / "other", "--seed", "2",
                     "--quiet"})
                .exit == 0);
    CHECK(ReadFile(folder.path() / "other" / "individuals.jsonl") !=
          ReadFile(folder.path() / "1" / "individuals.jsonl"));
  }
}

TEST_CASE("evolve never touches a folder that exists", "[evolve]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("e.yaml", Experiment("baseline"));
  std::filesystem::create_directory(folder.path() / "run");
  const auto ran = RunPlsc({"evolve", file, "-o", folder / "run"});
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("exists") != std::string::npos);
  CHECK(std::filesystem::is_empty(folder.path() / "run"));
  CHECK(RunPlsc({"evolve", file, "-o", folder / "no/run"}).exit == 1);
}

TEST_CASE("a wrong experiment starts nothing", "[evolve]") {
  struct Row {
    const char* why;
    const char* line;
    const char* message;
  };
  const std::vector<Row> rows = {
      {"unknown key", "populaton: 10\n", "population"},
      {"wrong type", "population: many\n", "e.yaml:2:13"},
      {"out of range", "mutation: 1.5\n", "e.yaml:2:11"},
      {"twice", "seed: 1\nseed: 2\n", "e.yaml:3:1"},
      {"not a number", "mutation: .nan\n", "e.yaml:2:11"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const test::TemporaryFolder folder;
      const std::string file = folder.Write(
          "e.yaml", std::string("plsc_experiment: 1\n") + row.line);
      const auto ran = RunPlsc({"evolve", file, "-o", folder / "run"});
      CHECK(ran.exit == 1);
      CHECK(ran.err.find(row.message) != std::string::npos);
      CHECK(folder.Files() == std::vector<std::string>{"e.yaml"});
    }
  }
}

}  // namespace
}  // namespace plsc
