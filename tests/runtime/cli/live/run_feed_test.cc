#include "runtime/cli/live/run_feed.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/runtime/cli/tiny_run.h"

namespace plsc::cli {
namespace {

using Value = nlohmann::json;

Value Shown(const std::vector<std::string>& words) {
  std::vector<std::string> all{"show"};
  all.insert(all.end(), words.begin(), words.end());
  all.insert(all.end(), {"--format", "json"});
  return Value::parse(test::RunPlsc(all).out);
}

TEST_CASE("a run's generations are those that show and the report have",
          "[run_feed]") {
  const std::string path = test::FinishedRun().path();
  RunFeed feed(path);
  const auto seen = feed.Look();
  REQUIRE(seen);
  CHECK(*seen);
  const Value json = Value::parse(feed.Json());
  const Value run = Shown({path});
  CHECK(json["state"] == "finished");
  REQUIRE(json["generations"].size() == run["generations"]);
  const Value& last = json["generations"].back();
  CHECK(last["best"] == run["best"]);
  CHECK(feed.best() == run["best"]);
  CHECK(last["census"] == run["census"]);
  // The best of a season, by what each robot has.
  for (std::size_t season = 0; season < json["seasons"].size(); ++season) {
    const int id = last["best_of"][season];
    const Value robot = Shown({path, std::to_string(id)});
    CHECK(robot["seasons"][season]["season"] == json["seasons"][season]);
    CHECK(robot["seasons"][season]["fitness"] ==
          last["fitness"]["best"][season]);
    CHECK(last["fitness"]["median"][season] <= last["fitness"]["best"][season]);
  }
  const auto again = feed.Look();
  REQUIRE(again);
  CHECK_FALSE(*again);
}

TEST_CASE("a robot comes with its first parents back to the beginning",
          "[run_feed]") {
  const std::string path = test::FinishedRun().path();
  RunFeed feed(path);
  REQUIRE(feed.Look());
  const auto text = feed.Robot(feed.best());
  REQUIRE(text);
  const Value robot = Value::parse(*text);
  const Value shown = Shown({path, "best"});
  CHECK(robot["id"] == shown["id"]);
  CHECK(robot["genotype"] == shown["genotype"]);
  CHECK(robot["parents"] == shown["parents"]);
  Value child = robot;
  for (const Value& parent : robot["lineage"]) {
    CHECK(parent["id"] == child["parents"][0]);
    CHECK(parent["generation"] < child["generation"]);
    child = parent;
  }
  CHECK(child["generation"] == 0);
  CHECK_FALSE(feed.Robot(0));
  CHECK_FALSE(feed.Robot(1000000));
}

TEST_CASE("another run under the name begins anew; none is a failure",
          "[run_feed]") {
  const test::TemporaryFolder folder;
  const std::string path = folder / "run.sqlite";
  RunFeed feed(path);
  CHECK_FALSE(feed.Look());
  std::filesystem::copy_file(test::FinishedRun().path(), path);
  REQUIRE(feed.Look());
  const std::string before = feed.Json();
  std::filesystem::remove(path);
  CHECK_FALSE(feed.Look());
  std::filesystem::copy_file(
      test::ChangedRun(folder, "UPDATE run SET seed = '77'"), path,
      std::filesystem::copy_options::overwrite_existing);
  const auto seen = feed.Look();
  REQUIRE(seen);
  CHECK(Value::parse(feed.Json())["generations"] ==
        Value::parse(before)["generations"]);
}

}  // namespace
}  // namespace plsc::cli
