#include "runtime/store/versions.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "runtime/scenario/scenario_profile.h"

namespace plsc {
namespace {

TEST_CASE("What another program began is told by what differs", "[versions]") {
  const Versions own = ThisProgram();
  CHECK(CheckVersions("run", own) == std::nullopt);
  struct Row {
    std::string Versions::*field;
    std::string what;
  };
  const std::vector<Row> rows = {{&Versions::plsc, "plsc"},
                                 {&Versions::ode, "ODE"},
                                 {&Versions::compiler, "compiler"},
                                 {&Versions::machine, "machine"}};
  for (const Row& row : rows) {
    INFO(row.what);
    Versions other = own;
    other.*row.field = "abacus";
    const auto failure = CheckVersions("run", other);
    REQUIRE(failure);
    CHECK(failure->text.find("'run' was begun with " + row.what + " abacus") ==
          0);
    CHECK_FALSE(MakeTheSame(own, other));
  }
}

TEST_CASE("Other arithmetic is the first reason", "[versions]") {
  Versions older = ThisProgram();
  older.results -= 1;
  older.plsc = "0.0.7";
  older.machine = "abacus";
  const auto failure = CheckVersions("run", older);
  REQUIRE(failure);
  CHECK(failure->text.find("'run' was made by other arithmetic") == 0);
  CHECK(failure->text.find("plsc 0.0.7 goes on with it") != std::string::npos);
  CHECK(failure->text.find("--allow-other-version") != std::string::npos);
  Versions same = older;
  same.machine = kAnyMachine;
  CHECK(MakeTheSame(older, same));
  same.results += 1;
  CHECK_FALSE(MakeTheSame(older, same));
}

TEST_CASE("A run of the articulated engine alone is of no machine",
          "[versions]") {
  Scenario scenario = PaperScenario();
  CHECK(VersionsFor(scenario) == ThisProgram());
  scenario.seasons[0].physics.engine = EngineKind::kArticulated;
  CHECK(VersionsFor(scenario) == ThisProgram());
  scenario.seasons[1].physics.engine = EngineKind::kArticulated;
  Versions anywhere = VersionsFor(scenario);
  CHECK(anywhere.machine == "any");
  // What made it is a fact still, and keeps nobody from going on.
  anywhere.compiler = "another";
  anywhere.ode = "another";
  CHECK(CheckVersions("run", anywhere) == std::nullopt);
  CHECK(MakeTheSame(anywhere, VersionsFor(scenario)));
  anywhere.plsc = "another";
  CHECK(CheckVersions("run", anywhere));
}

}  // namespace
}  // namespace plsc
