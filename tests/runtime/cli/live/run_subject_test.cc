#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "runtime/cli/live/subject.h"
#include "tests/runtime/cli/tiny_run.h"

namespace plsc::cli {
namespace {

using Value = nlohmann::json;

server::Response Got(Subject& subject, const std::string& target,
                     const std::string& query = "") {
  server::Request request;
  request.method = "GET";
  request.target = target;
  request.query = query;
  return subject.Answer(request);
}

TEST_CASE("a run's page has its scenario; rows and robots are asked for",
          "[run_subject]") {
  auto joined = JoinRun(test::FinishedRun().path());
  REQUIRE(joined);
  Subject& subject = **joined;
  const Value data = Value::parse(subject.PageData());
  CHECK(data["follow"] == "run");
  CHECK_FALSE(data["scenario"].get<std::string>().empty());
  const Value run = Value::parse(Got(subject, "run").body);
  CHECK(run["generations"].size() == 3);
  const int best = run["generations"][2]["best"];
  const Value robot =
      Value::parse(Got(subject, "robot", "id=" + std::to_string(best)).body);
  CHECK(robot["id"] == best);
  REQUIRE(subject.Standing().size() == 1);
  CHECK(Value::parse(subject.Standing()[0].second) ==
        Value{{"generations", 3}, {"state", "finished"}});
  CHECK(subject.Look().empty());
}

TEST_CASE("what a run does not have is refused", "[run_subject]") {
  auto joined = JoinRun(test::FinishedRun().path());
  REQUIRE(joined);
  Subject& subject = **joined;
  CHECK(Got(subject, "robot", "id=999999").status == 500);
  CHECK(Got(subject, "robot", "id=x").status == 400);
  CHECK(Got(subject, "robot", "id=1x").status == 400);
  CHECK(Got(subject, "robot").status == 400);
  CHECK(Got(subject, "run", "run=plastic/1").status == 500);
  CHECK(Got(subject, "study").status == 404);
  CHECK(Got(subject, "save").status == 404);
  const test::TemporaryFolder folder;
  CHECK_FALSE(JoinRun(folder / "none.sqlite"));
  CHECK_FALSE(JoinRun(folder.Write("a.sqlite", "nonsense")));
  CHECK_FALSE(JoinStudy(folder.path()));
}

TEST_CASE("a study's page has its runs, each by its name", "[run_subject]") {
  const test::TemporaryFolder folder;
  const std::string study = folder.Write("study.yaml", R"(
name: two
seed: 3
repetitions: 2
base:
  population: 4
  offspring: 4
  generations: 2
  scenario:
    seasons: [{name: flat, duration: 1 s}]
experiments:
  plastic: {}
)");
  REQUIRE(test::RunPlsc({"study", "run", study, "-o", folder / "out", "--only",
                         "plastic/1", "--quiet"})
              .exit == 0);
  auto joined = JoinStudy(folder / "out");
  REQUIRE(joined);
  Subject& subject = **joined;
  const Value data = Value::parse(subject.PageData());
  CHECK(data["follow"] == "study");
  CHECK(data["name"] == "two");
  const Value all = Value::parse(Got(subject, "study").body);
  REQUIRE(all["runs"].size() == 2);
  CHECK(all["runs"][0]["run"] == "plastic/1");
  CHECK(all["runs"][0]["state"] == "done");
  CHECK(all["runs"][1]["state"] == "missing");
  CHECK(subject.Standing().empty());
  const Value run = Value::parse(Got(subject, "run", "run=plastic%2F1").body);
  CHECK(run["generations"].size() == 2);
  REQUIRE(subject.Standing().size() == 1);
  CHECK(subject.Standing()[0].first == "run:plastic/1");
  CHECK(Got(subject, "run", "run=plastic%2F2").status == 500);
  CHECK(Got(subject, "run", "run=plastic%2F3").status == 500);
  CHECK(Got(subject, "run").status == 500);
}

}  // namespace
}  // namespace plsc::cli
