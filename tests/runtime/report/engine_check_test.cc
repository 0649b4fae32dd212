#include "runtime/report/engine_check.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "runtime/scenario/scenario_profile.h"

namespace plsc {
namespace {

SeasonResult Walked(std::optional<double> speed) {
  SeasonResult result;
  result.behaviour.is_valid = speed.has_value();
  result.behaviour.displacement_velocity_hill = speed.value_or(0);
  return result;
}

/// Two seasons: as given, and one that nobody completed.
LivedTwice Robot(int id, std::optional<double> stored,
                 std::optional<double> now) {
  return {id,
          {{Walked(stored), Walked(std::nullopt)}},
          {{Walked(now), Walked(std::nullopt)}}};
}

TEST_CASE("Ranks correlate as Spearman has it", "[engine_check]") {
  struct Row {
    const char* why;
    std::vector<double> x, y;
    std::optional<double> expected;
  };
  const std::vector<Row> rows = {
      {"the same order, other distances", {1, 2, 3, 4}, {0, 5, 6, 90}, 1},
      {"turned round", {1, 2, 3, 4}, {4, 3, 2, 1}, -1},
      // 1 - 6 sum d^2 / (n (n^2 - 1)), d = 1, -1, 0, 0
      {"two neighbours changed", {1, 2, 3, 4}, {2, 1, 3, 4}, 0.8},
      // R: cor(c(1, 2, 2, 4), c(1, 3, 2, 4), method = "spearman")
      {"a tie", {1, 2, 2, 4}, {1, 3, 2, 4}, 0.9486832980505138},
      {"all equal", {1, 1, 1}, {1, 2, 3}, std::nullopt},
      {"one alone", {1}, {1}, std::nullopt},
      {"nobody", {}, {}, std::nullopt},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    const auto found = RankCorrelation(row.x, row.y);
    REQUIRE(found.has_value() == row.expected.has_value());
    if (found) CHECK(*found == Approx(*row.expected).epsilon(1e-14));
  }
}

TEST_CASE("A season's check is of those who completed it by either engine",
          "[engine_check]") {
  EngineCheck check{EngineKind::kArticulated, 7, 5, {}};
  check.seasons = CheckSeasons(
      PaperScenario(),
      {Robot(4, 0.01, 0.012), Robot(2, 0.03, 0.02), Robot(9, 0.02, 0.021),
       Robot(1, std::nullopt, 0.5), Robot(3, 0.5, std::nullopt)});
  REQUIRE(check.seasons.size() == 2);
  const SeasonCheck& flat = check.seasons[0];
  CHECK(flat.both == 3);
  CHECK(flat.only_stored == 1);
  CHECK(flat.only_now == 1);
  CHECK(*flat.rank_correlation == Approx(0.5));
  CHECK(*flat.median_difference == Approx(0.002));
  CHECK(*flat.largest_difference == Approx(0.01));
  CHECK(check.seasons[1].both == 0);
  CHECK_FALSE(check.seasons[1].median_difference);
  CHECK(
      EngineCheckText(check) ==
      "5 robots of generation 7, by the engine articulated\n"
      "season       stored by    both only stored only now   ranks  median "
      "cm/s largest cm/s\n"
      "flat         ode             3           1        1   0.500        "
      "0.200        1.000\n"
      "tilted       ode             0           0        0       -            "
      "-            -\n");
  const auto json = EngineCheckJson(check);
  CHECK(json["engine"] == "articulated");
  CHECK(json["generation"] == 7);
  CHECK(json["seasons"][0]["stored_engine"] == "ode");
  CHECK(json["seasons"][0]["lives"][3] ==
        nlohmann::ordered_json{{"id", 1}, {"stored", nullptr}, {"now", 0.5}});
  CHECK(json["seasons"][1]["rank_correlation"].is_null());
}

}  // namespace
}  // namespace plsc
