#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"

namespace plsc {
namespace {

using Json = nlohmann::json;
using test::RunPlsc;

TEST_CASE("show tells how far a run is and who is best", "[show]") {
  const test::TinyRun& run = test::FinishedRun();
  const auto text = RunPlsc({"show", run.path()});
  CHECK(text.exit == 0);
  CHECK(text.out.find("finished: 3 of 3 generations, 18 of 18 robots") !=
        std::string::npos);
  CHECK(text.out.find("season flat: ") != std::string::npos);
  const Json told =
      Json::parse(RunPlsc({"show", run.path(), "--format", "json"}).out);
  CHECK(told["state"] == "finished");
  CHECK(told["best"] == run.summary()["best"]["id"]);
  CHECK(told["versions"].contains("ode"));
}

TEST_CASE("show tells where an individual comes from", "[show]") {
  const test::TinyRun& run = test::FinishedRun();
  const Json child =
      Json::parse(RunPlsc({"show", run.path(), "18", "--format", "json"}).out);
  CHECK(child["id"] == 18);
  CHECK(child["generation"] == 2);
  REQUIRE(child["parents"].size() == 2);
  CHECK(child["seasons"].size() == 2);
  CHECK(child["lineage"].size() >= 3);
  CHECK(child["lineage"][0]["id"] == 18);
  const std::string genotype = child["genotype"];
  CHECK(RunPlsc({"show", run.path(), "18", "--genotype"}).out == genotype);
  const auto text = RunPlsc({"show", run.path(), "18", "--lineage", "1"});
  CHECK(text.out.find("robot_18 of generation 2: child of ") == 0);
  CHECK(text.out.find(genotype) != std::string::npos);
  CHECK(text.out.find("│ C 1 │") != std::string::npos);
  CHECK(RunPlsc({"show", run.path(), "1"}).out.find("drawn at random") !=
        std::string::npos);
}

TEST_CASE("show says what it cannot find", "[show]") {
  const test::TinyRun& run = test::FinishedRun();
  for (const char* id : {"0", "-3", "99", "x", "1.5", "99999999999"}) {
    INFO(id);
    const auto shown = RunPlsc({"show", run.path(), id});
    CHECK(shown.exit != 0);
    CHECK_FALSE(shown.err.empty());
  }
  const test::TemporaryFolder folder;
  for (const std::string& path :
       {folder / "none", folder.path().string(), folder.Write("text", "a"),
        folder.Write("empty", "")}) {
    INFO(path);
    CHECK(RunPlsc({"show", path}).exit == 1);
  }
}

}  // namespace
}  // namespace plsc
