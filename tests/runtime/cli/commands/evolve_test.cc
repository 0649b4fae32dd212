// Real runs, small: few robots, seasons of a second.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "runtime/store/result_dump.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using Json = nlohmann::json;
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
    const auto ran = RunPlsc({"evolve", file, "-o", folder / "run.sqlite",
                              "--jobs", "2", "--format", "json"});
    INFO(ran.err);
    REQUIRE(ran.exit == 0);
    const Json summary = Json::parse(ran.out);
    CHECK(summary["finished"] == true);
    CHECK(summary["generations"] == 3);
    CHECK(summary["evaluations"] == 18);
    const std::string best = summary["best"]["genotype"];
    CHECK(best ==
          RunPlsc({"show", folder / "run.sqlite", "best", "--genotype"}).out);
    CHECK(RunPlsc({"check", "-"}, best).exit == 0);
    CHECK(ran.err.find("generation 3/3") != std::string::npos);
  }
}

TEST_CASE("evolve prints the best robot's genotype and bodies", "[evolve]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("e.yaml", Experiment("plasticoding"));
  const auto ran =
      RunPlsc({"evolve", file, "-o", folder / "run.sqlite", "--quiet"});
  REQUIRE(ran.exit == 0);
  CHECK(ran.err.empty());
  CHECK(ran.out.find("best robot: robot_") == 0);
  CHECK(ran.out.find("plsc 1\n") != std::string::npos);
  CHECK(ran.out.find("season flat: speed") != std::string::npos);
  CHECK(ran.out.find("│ C 1 │") != std::string::npos);
}

std::string Dump(const std::string& path) {
  const Expected<std::string, Failure> dump = DumpResults(path);
  REQUIRE(dump);
  return *dump;
}

TEST_CASE("the number of workers changes no bit of a run", "[evolve]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("e.yaml", Experiment("plasticoding"));
  for (const char* jobs : {"1", "2", "3"})
    REQUIRE(RunPlsc({"evolve", file, "-o", folder / jobs, "--jobs", jobs,
                     "--quiet"})
                .exit == 0);
  const std::string one = Dump(folder / "1");
  CHECK(one.size() > 1000);
  CHECK(Dump(folder / "2") == one);
  CHECK(Dump(folder / "3") == one);
  SECTION("another seed is another run") {
    REQUIRE(RunPlsc({"evolve", file, "-o", folder / "other", "--seed", "2",
                     "--quiet"})
                .exit == 0);
    CHECK(Dump(folder / "other") != one);
  }
}

TEST_CASE("evolve never touches what exists", "[evolve]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("e.yaml", Experiment("baseline"));
  const std::string taken = folder.Write("run.sqlite", "mine");
  const auto ran = RunPlsc({"evolve", file, "-o", taken});
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("exists") != std::string::npos);
  CHECK(ReadFile(taken) == "mine");
  CHECK(RunPlsc({"evolve", file, "-o", folder / "no/run"}).exit == 1);
  // To go on with what is no run changes it as little.
  CHECK(RunPlsc({"evolve", "--resume", taken}).exit == 1);
  CHECK(RunPlsc({"evolve", file, "-o", taken, "--or-resume"}).exit == 1);
  CHECK(ReadFile(taken) == "mine");
}

TEST_CASE("evolve goes on with a run of the same experiment only", "[evolve]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("e.yaml", Experiment("plasticoding"));
  const std::string run = folder / "run.sqlite";
  REQUIRE(RunPlsc({"evolve", file, "-o", run, "--quiet"}).exit == 0);
  const std::string before = Dump(run);
  const auto again =
      RunPlsc({"evolve", "--resume", run, "--quiet", "--format", "json"});
  CHECK(again.exit == 0);
  CHECK(Json::parse(again.out)["simulations"] == 0);
  CHECK(Json::parse(again.out)["finished"] == true);
  CHECK(RunPlsc({"evolve", file, "-o", run, "--or-resume", "--quiet"}).exit ==
        0);
  const auto other = RunPlsc(
      {"evolve", file, "-o", run, "--or-resume", "--quiet", "--seed", "9"});
  CHECK(other.exit == 1);
  CHECK(other.err.find("another experiment or seed") != std::string::npos);
  CHECK(Dump(run) == before);
}

TEST_CASE("evolve wants an experiment and a store, or a run to go on with",
          "[evolve]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("e.yaml", Experiment("baseline"));
  CHECK(RunPlsc({"evolve"}).exit == 2);
  CHECK(RunPlsc({"evolve", file}).exit == 2);
  CHECK(RunPlsc({"evolve", file, "--resume", "run"}).exit == 2);
  CHECK(RunPlsc({"evolve", "--resume", "run", "--seed", "1"}).exit == 2);
  CHECK(RunPlsc({"evolve", "--resume", folder / "none"}).exit == 1);
  CHECK(folder.Files() == std::vector<std::string>{"e.yaml"});
}

TEST_CASE("a damaged run is told, and made again from what is whole",
          "[evolve]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("e.yaml", Experiment("plasticoding"));
  const std::string run = folder / "run.sqlite";
  REQUIRE(RunPlsc({"evolve", file, "-o", run, "--quiet"}).exit == 0);
  const std::string whole = ReadFile(run);
  const std::string dump = Dump(run);
  struct Row {
    const char* why;
    std::size_t begin;  // permille of the file
    std::size_t end;    // where 0xa5 is written; 0: cut off at begin
    bool is_readable;   // anything at all
  };
  const std::vector<Row> rows = {
      {"the last third is cut off", 666, 0, true},
      {"a page in the middle", 500, 520, true},
      {"the end", 900, 1000, true},
      {"the beginning", 0, 10, false},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      std::string damaged = whole.substr(
          0, row.end == 0 ? row.begin * whole.size() / 1000 : whole.size());
      for (std::size_t i = row.begin * whole.size() / 1000;
           i < row.end * whole.size() / 1000; ++i)
        damaged[i] = static_cast<char>(0xa5);
      const std::string path = folder.Write("damaged.sqlite", damaged);
      const auto refused = RunPlsc({"evolve", "--resume", path, "--quiet"});
      INFO(refused.err);
      CHECK(refused.exit == 1);
      const auto made =
          RunPlsc({"evolve", "--salvage", path, "-o", folder / "new.sqlite",
                   "--quiet", "--format", "json"});
      INFO(made.err);
      CHECK(ReadFile(path) == damaged);
      REQUIRE((made.exit == 0) == row.is_readable);
      if (!row.is_readable) continue;
      CHECK(refused.err.find("--salvage") != std::string::npos);
      CHECK(Json::parse(made.out)["finished"] == true);
      CHECK(Dump(folder / "new.sqlite") == dump);
    }
  }
  SECTION("what is whole is not simulated again") {
    const auto made =
        RunPlsc({"evolve", "--salvage", run, "-o", folder / "new.sqlite",
                 "--quiet", "--format", "json"});
    CHECK(Json::parse(made.out)["simulations"] == 0);
    CHECK(Dump(folder / "new.sqlite") == dump);
  }
}

TEST_CASE("a shared cache saves simulations and changes no bit", "[evolve]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("e.yaml", Experiment("plasticoding"));
  const auto evolve = [&](const char* run, std::vector<std::string> more) {
    std::vector<std::string> arguments = {
        "evolve", file, "-o", folder / run, "--quiet", "--format", "json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto ran = RunPlsc(arguments);
    INFO(ran.err);
    REQUIRE(ran.exit == 0);
    return Json::parse(ran.out);
  };
  const Json plain = evolve("plain", {});
  const Json first = evolve("first", {"--cache", folder / "cache"});
  const Json second = evolve("second", {"--cache", folder / "cache"});
  CHECK(first["simulations"] == plain["simulations"]);
  CHECK(second["simulations"] == 0);
  CHECK(second["looked_up"] == 36);
  CHECK(Dump(folder / "first") == Dump(folder / "plain"));
  CHECK(Dump(folder / "second") == Dump(folder / "plain"));
  const auto wrong = RunPlsc({"evolve", file, "-o", folder / "third", "--cache",
                              folder.Write("text", "no cache")});
  CHECK(wrong.exit == 1);
  CHECK(ReadFile(folder / "text") == "no cache");
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
      const auto ran = RunPlsc({"evolve", file, "-o", folder / "run.sqlite"});
      CHECK(ran.exit == 1);
      CHECK(ran.err.find(row.message) != std::string::npos);
      CHECK(folder.Files() == std::vector<std::string>{"e.yaml"});
    }
  }
}

}  // namespace
}  // namespace plsc
