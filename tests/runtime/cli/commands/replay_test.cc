#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"

namespace plsc {
namespace {

using Json = nlohmann::json;
using test::RunPlsc;

TEST_CASE("every robot of a run comes out again, bit for bit", "[replay]") {
  const test::TinyRun& run = test::FinishedRun();
  const auto best = RunPlsc({"replay", run.path()});
  INFO(best.err);
  CHECK(best.exit == 0);
  CHECK(best.out.find("values in 2 seasons equal") != std::string::npos);
  const auto all = RunPlsc({"replay", run.path(), "--all", "--format", "json"});
  INFO(all.err);
  CHECK(all.exit == 0);
  CHECK(std::count(all.out.begin(), all.out.end(), '\n') == 18);
  const Json first = Json::parse(all.out.substr(0, all.out.find('\n')));
  CHECK(first["id"] == 1);
  CHECK(first["values"] > 80);
  CHECK(first["differences"].empty());
}

TEST_CASE("replay tells which stored number does not come out", "[replay]") {
  struct Row {
    const char* why;
    const char* sql;
    const char* name;
  };
  const std::vector<Row> rows = {
      {"a speed, by its last bit",
       "UPDATE simulation SET displacement_velocity_hill = "
       "displacement_velocity_hill * (1 + 2.3e-16) "
       "WHERE displacement_velocity_hill IS NOT NULL",
       "displacement_velocity_hill"},
      {"a state", "UPDATE simulation SET state_hash = '00000000000000ff'",
       "state_hash"},
      {"a size", "UPDATE body SET absolute_size = 1 + absolute_size",
       "absolute_size"},
      {"a fitness", "UPDATE evaluation SET fitness = 17", "fitness"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const test::TemporaryFolder folder;
      const auto ran = RunPlsc({"replay", test::ChangedRun(folder, row.sql),
                                "--all", "--jobs", "2"});
      CHECK(ran.exit == 1);
      CHECK(ran.out.find(row.name) != std::string::npos);
      CHECK(ran.err.find("came out otherwise") != std::string::npos);
    }
  }
}

TEST_CASE("replay trusts no damaged number", "[replay]") {
  const test::TemporaryFolder folder;
  const std::string copy = test::DamagedRun(
      folder, "UPDATE evaluation SET fitness = 17 WHERE individual = 3");
  const auto one = RunPlsc({"replay", copy, "3"});
  CHECK(one.exit == 1);
  CHECK(one.out.empty());
  CHECK(one.err == "error: '" + copy +
                       "' is damaged: the evaluation of robot 3 is not what "
                       "it was\n");
  CHECK(RunPlsc({"replay", copy, "4"}).exit == 0);
  const auto all = RunPlsc({"replay", copy, "--all"});
  CHECK(all.exit == 1);
  CHECK(all.out.empty());
}

TEST_CASE("replay --engine tells how survivors rank by that engine",
          "[replay]") {
  const std::string run = test::FinishedRun().path();
  const auto text = RunPlsc({"replay", run, "--engine", "articulated"});
  INFO(text.err);
  CHECK(text.exit == 0);
  CHECK(text.out.find("6 robots of generation 2, by the engine articulated\n"
                      "season ") == 0);
  CHECK(std::count(text.out.begin(), text.out.end(), '\n') == 4);
  // By the engine of the run nothing differs.
  const auto same =
      RunPlsc({"replay", run, "--all", "--engine", "ode", "--format", "json"});
  CHECK(same.exit == 0);
  const Json check = Json::parse(same.out);
  CHECK(check["engine"] == "ode");
  CHECK(check["generation"].is_null());
  CHECK(check["robots"] == 18);
  for (const Json& season : check["seasons"]) {
    CHECK(season["largest_difference"] == 0);
    CHECK(season["only_now"] == 0);
    CHECK(season["lives"].size() == 18);
  }
  const auto two =
      RunPlsc({"replay", run, "3", "best", "--engine", "articulated"});
  CHECK(two.out.find("2 robots, by the engine") == 0);
  CHECK(RunPlsc({"replay", run, "--engine", "bullet"}).exit == 2);
  const test::TemporaryFolder folder;
  const auto iterative = RunPlsc(
      {"replay",
       test::ChangedRun(folder,
                        "UPDATE run SET experiment = replace(experiment, "
                        "'solver: direct', 'solver: iterative')"),
       "--engine", "articulated"});
  CHECK(iterative.exit == 1);
  CHECK(iterative.err.find("cannot be lived by the engine articulated: season "
                           "'") != std::string::npos);
}

TEST_CASE("replay expects differences from other arithmetic", "[replay]") {
  const test::TemporaryFolder folder;
  const std::string run =
      test::ChangedRun(folder, "UPDATE run SET results = 1, plsc = '0.1.0'");
  const auto same = RunPlsc({"replay", run});
  CHECK(same.err.find("made by other arithmetic (results 1, and of this "
                      "program 2): differences expected") != std::string::npos);
  const test::TemporaryFolder second;
  const auto other = RunPlsc(
      {"replay", test::ChangedRun(second,
                                  "UPDATE run SET results = 1, plsc = '0.1.0'; "
                                  "UPDATE evaluation SET fitness = 17")});
  CHECK(other.exit == 1);
  CHECK(other.err.find("plsc 0.1.0 repeats it") != std::string::npos);
}

TEST_CASE("replay says what it cannot find", "[replay]") {
  const test::TemporaryFolder folder;
  CHECK(RunPlsc({"replay", test::FinishedRun().path(), "77"}).exit == 1);
  CHECK(RunPlsc({"replay", folder / "none"}).exit == 1);
  CHECK(RunPlsc({"replay"}).exit == 2);
}

}  // namespace
}  // namespace plsc
