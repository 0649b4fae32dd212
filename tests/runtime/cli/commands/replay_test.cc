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

TEST_CASE("replay says what it cannot find", "[replay]") {
  const test::TemporaryFolder folder;
  CHECK(RunPlsc({"replay", test::FinishedRun().path(), "77"}).exit == 1);
  CHECK(RunPlsc({"replay", folder / "none"}).exit == 1);
  CHECK(RunPlsc({"replay"}).exit == 2);
}

}  // namespace
}  // namespace plsc
