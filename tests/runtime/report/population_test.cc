// Against SQL that says in one statement what a mean is (docs/runs.md).

#include "runtime/report/population.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "runtime/store/verify.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {
namespace {

/// The mean over the survivors of a generation, of a column of the view
/// `result`.
double MeanBySql(Database& database, const ReportMeasure& measure,
                 const std::string& season, int generation) {
  Statement row(database, "SELECT avg(" + measure.id +
                              ") FROM population JOIN result ON result.id = "
                              "population.id WHERE population.generation = ? "
                              "AND season = ?");
  REQUIRE(row.With(generation, season).Next());
  const double mean = row.TakeReal() * measure.scale;
  row.Run();
  return mean;
}

}  // namespace

TEST_CASE("Means are those that SQL finds, for every measure and season",
          "[population]") {
  const test::Scratch scratch;
  test::WriteRun(scratch / "run");
  Database database;
  REQUIRE_FALSE(database.Open(scratch / "run", Database::Mode::kRead));
  const auto measures = AllMeasures();
  const PopulationSummary summary =
      SummarisePopulation(database, measures, false);
  REQUIRE_FALSE(database.TakeFailure());
  REQUIRE(summary.generations > 2);
  REQUIRE(summary.seasons.size() > 1);
  int numbers = 0;
  for (std::size_t m = 0; m < measures.size(); ++m)
    for (std::size_t s = 0; s < summary.seasons.size(); ++s) {
      const Series& series = summary.of(m, s);
      REQUIRE(series.means.size() ==
              static_cast<std::size_t>(summary.generations));
      CHECK(series.spreads.empty());
      for (int g = 0; g < summary.generations; ++g) {
        CAPTURE(measures[m].id, summary.seasons[s], g);
        const double mean = series.means[static_cast<std::size_t>(g)];
        const double expected =
            MeanBySql(database, measures[m], summary.seasons[s], g);
        if (std::isnan(expected))
          CHECK(std::isnan(mean));
        else
          CHECK(mean == Approx(expected).margin(1e-12));
        numbers += std::isnan(mean) ? 0 : 1;
      }
    }
  CHECK(numbers > 100);
}

TEST_CASE("The best robot's values are those that SQL finds", "[population]") {
  const test::Scratch scratch;
  test::WriteRun(scratch / "run");
  Database database;
  REQUIRE_FALSE(database.Open(scratch / "run", Database::Mode::kRead));
  const auto measures = AllMeasures();
  const PopulationSummary summary =
      SummarisePopulation(database, measures, false);
  int numbers = 0;
  for (std::size_t m = 0; m < measures.size(); ++m)
    for (std::size_t s = 0; s < summary.seasons.size(); ++s) {
      Statement row(database, "SELECT " + measures[m].id +
                                  " FROM generation JOIN result ON result.id = "
                                  "generation.best WHERE season = ? "
                                  "ORDER BY generation.number");
      row.With(summary.seasons[s]);
      const Series& series = summary.of(m, s);
      REQUIRE(series.best.size() == series.means.size());
      for (const double best : series.best) {
        CAPTURE(measures[m].id, summary.seasons[s]);
        REQUIRE(row.Next());
        const double expected = row.TakeReal() * measures[m].scale;
        if (std::isnan(expected))
          CHECK(std::isnan(best));
        else
          CHECK(best == Approx(expected).margin(1e-12));
        numbers += std::isnan(best) ? 0 : 1;
      }
      CHECK_FALSE(row.Next());
    }
  CHECK(numbers > 50);
}

TEST_CASE("Errors of servos are those of the last survivors", "[population]") {
  const test::Scratch scratch;
  test::WriteRun(scratch / "run");
  Database database;
  REQUIRE_FALSE(database.Open(scratch / "run", Database::Mode::kRead));
  const auto measures = *ChooseMeasures("servo_error_worst, size");
  const PopulationSummary summary =
      SummarisePopulation(database, measures, true);
  // What is measured and what is only told are two things.
  REQUIRE(summary.series.size() == 2 * summary.seasons.size());
  REQUIRE(summary.errors.size() == summary.seasons.size());
  for (std::size_t s = 0; s < summary.seasons.size(); ++s) {
    Statement row(database,
                  "SELECT servo_error_median, servo_error_worst FROM "
                  "population JOIN result ON result.id = population.id "
                  "WHERE population.generation = ? AND season = ? "
                  "AND servo_error_median IS NOT NULL");
    std::vector<double> medians;
    double worst = 0;
    row.With(summary.generations - 1, summary.seasons[s]);
    while (row.Next()) {
      medians.push_back(row.TakeReal());
      worst = std::max(worst, row.TakeReal());
    }
    REQUIRE(medians.size() > 2);
    CHECK(worst > 0);
    CHECK(summary.errors[s].median == QuartilesOf(medians).median);
    CHECK(summary.errors[s].worst == worst);
    CHECK(summary.of(0, s).means.size() ==
          static_cast<std::size_t>(summary.generations));
  }
}

TEST_CASE("A store of before has no errors of servos", "[population]") {
  Database database;
  REQUIRE_FALSE(database.Open(PLSC_SOURCE_DIR "/tests/data/run_schema_2.sqlite",
                              Database::Mode::kRead));
  REQUIRE_FALSE(CheckIdentity(database));
  const auto measures = *ChooseMeasures("core_turns, contacts");
  const PopulationSummary summary =
      SummarisePopulation(database, measures, false);
  REQUIRE_FALSE(database.TakeFailure());
  CHECK(std::isnan(summary.of(0, 0).means.back()));
  CHECK(summary.of(1, 0).means.back() > 0);
  REQUIRE(summary.errors.size() == 2);
  CHECK(std::isnan(summary.errors[0].median));
  CHECK(std::isnan(summary.errors[0].worst));
}

TEST_CASE("Quartiles over robots are told when asked for", "[population]") {
  const test::Scratch scratch;
  test::WriteRun(scratch / "run", 2);
  Database database;
  REQUIRE_FALSE(database.Open(scratch / "run", Database::Mode::kRead));
  const auto measures = *ChooseMeasures("size");
  const auto summary = SummarisePopulation(database, measures, true);
  REQUIRE(summary.generations == 2);
  CHECK(summary.survivors.size() > 1);
  for (const Series& series : summary.series) {
    REQUIRE(series.spreads.size() == 2);
    std::vector<double> sizes;
    Statement row(database,
                  "SELECT absolute_size FROM population JOIN result ON "
                  "result.id = population.id WHERE population.generation = 1 "
                  "AND season = ? AND absolute_size IS NOT NULL");
    row.With(summary.seasons[static_cast<std::size_t>(&series -
                                                      summary.series.data())]);
    while (row.Next()) sizes.push_back(row.TakeReal());
    const Quartiles expected = QuartilesOf(sizes);
    CHECK(series.spreads[1].low == expected.low);
    CHECK(series.spreads[1].median == expected.median);
    CHECK(series.spreads[1].high == expected.high);
  }
}

TEST_CASE("A run without a generation has an empty summary", "[population]") {
  const test::Scratch scratch;
  test::WriteRun(scratch / "run", 0);
  Database database;
  REQUIRE_FALSE(database.Open(scratch / "run", Database::Mode::kRead));
  const auto summary = SummarisePopulation(database, PaperMeasures(), true);
  CHECK_FALSE(database.TakeFailure());
  CHECK(summary.generations == 0);
  CHECK(summary.survivors.empty());
  CHECK(summary.of(0, 0).means.empty());
}

}  // namespace plsc
