#include "runtime/report/claim_results.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "tests/runtime/report/claimed_study.h"
#include "tests/runtime/report/reported_study.h"

namespace plsc {

namespace {

using test::ClaimedStudy;
using test::SizeClaim;

}  // namespace

TEST_CASE("Claims are held against the runs that they name",
          "[claim_results]") {
  Claim best = SizeClaim(ClaimKind::kGreater, "best");
  best.of = ClaimOf::kBest;
  Claim seasons = SizeClaim(ClaimKind::kLess, "seasons");
  seasons.experiments = {"b"};
  seasons.seasons = {"flat", "tilted"};
  Claim value = SizeClaim(ClaimKind::kValue, "value");
  value.value = 12;
  const auto results = ClaimResultsOf(ClaimedStudy(
      {SizeClaim(ClaimKind::kGreater, "bigger"), best, seasons, value}));
  REQUIRE(results.size() == 4);
  CHECK(results[0].recorded.medians == std::vector<double>{12, 2});
  CHECK(results[0].recorded.runs == std::vector<std::size_t>{5, 5});
  CHECK(results[0].planned == std::vector<std::size_t>{5, 5});
  CHECK_FALSE(results[0].relived);
  CHECK_FALSE(results[0].is_early);
  CHECK(results[1].recorded.medians == std::vector<double>{24, 4});
  CHECK(results[2].recorded.medians == std::vector<double>{2, 3});
  CHECK(results[2].recorded.is_paired);
  CHECK(results[2].recorded.effect->a == 0);
  CHECK(results[3].recorded.ours == 12);
}

TEST_CASE("A family is corrected together, and equal is in none",
          "[claim_results]") {
  Claim other = SizeClaim(ClaimKind::kLess, "other family");
  other.of = ClaimOf::kBest;
  other.family = "best";
  const auto results = ClaimResultsOf(
      ClaimedStudy({SizeClaim(ClaimKind::kGreater, "bigger"),
                    SizeClaim(ClaimKind::kLess, "smaller"),
                    SizeClaim(ClaimKind::kEqual, "as big"), other}));
  const double p = 2.0 / 252;  // five against five, wholly apart
  for (const ClaimResult& one : results) CHECK(*one.recorded.p == Approx(p));
  CHECK(*results[0].recorded.holm == Approx(2 * p));
  CHECK(results[0].family == 2);
  CHECK(results[0].recorded.verdict == Verdict::kHolds);
  CHECK(results[1].recorded.verdict == Verdict::kOpposite);
  CHECK_FALSE(results[2].recorded.holm);
  CHECK(*results[3].recorded.holm == Approx(p));
  CHECK(ClaimsSummary(results) ==
        "4 claims: 1 holds, 2 opposite, 1 too few runs");
  CHECK(ClaimsSummary({}).empty());
}

TEST_CASE("No other claim changes a claim's interval", "[claim_results]") {
  StudyReport one = ClaimedStudy({SizeClaim(ClaimKind::kGreater, "bigger")});
  StudyReport two = ClaimedStudy({SizeClaim(ClaimKind::kLess, "smaller"),
                                  SizeClaim(ClaimKind::kGreater, "bigger")});
  for (StudyReport* report : {&one, &two})
    report->runs[0].reading.population.series[0].means[1] = 2.5;
  CHECK(ClaimResultsOf(one)[0].recorded.effect->interval ==
        ClaimResultsOf(two)[1].recorded.effect->interval);
}

TEST_CASE("A claim that was withdrawn is told and counts", "[claim_results]") {
  StudyReport report = ClaimedStudy({SizeClaim(ClaimKind::kGreater, "bigger")});
  ClaimsVersion later = report.claims[0].record[0];
  later.runs_begun = 3;
  later.claims = {SizeClaim(ClaimKind::kLess, "smaller")};
  report.claims[0].record.push_back(later);
  const auto results = ClaimResultsOf(report);
  REQUIRE(results.size() == 2);
  CHECK(results[0].stated.claim.name == "smaller");
  CHECK(results[0].stated.since == 1);
  CHECK(results[0].family == 2);
  CHECK(results[1].stated.withdrawn == 1);
}

TEST_CASE("Runs of another study, or that are unfinished, are told apart",
          "[claim_results]") {
  StudyReport report = ClaimedStudy({SizeClaim(ClaimKind::kGreater, "bigger")});
  report.runs[0].input.study = std::nullopt;
  report.runs[1].reading.state = RunState::kRunning;
  const auto results = ClaimResultsOf(report);
  CHECK(results[0].planned == std::vector<std::size_t>{4, 5});
  CHECK(results[0].recorded.runs == std::vector<std::size_t>{4, 5});
  CHECK(results[0].is_early);
}

TEST_CASE("A course needs the generation that it speaks of",
          "[claim_results]") {
  Claim course = SizeClaim(ClaimKind::kMinimumBefore, "course");
  course.minimum_before = 2;
  CHECK(ClaimResultsOf(ClaimedStudy({course}))[0].recorded.runs[0] == 0);
  StudyReport report = ClaimedStudy({course});
  report.generation = 2;
  for (ReportRun& run : report.runs)
    run.reading.population.series[0].means = {3, 1, 2};
  const auto result = ClaimResultsOf(report)[0];
  CHECK(result.recorded.runs_so == 5);
  CHECK(result.recorded.minimum == 1);
  // Its minimum may be where there is no number.
  report.runs[0].reading.population.series[0].means[1] = NAN;
  CHECK(ClaimResultsOf(report)[0].recorded.runs[0] == 4);
}

TEST_CASE("Of relived lives a claim has a finding of its own",
          "[claim_results]") {
  StudyReport report = test::RelivedClaims();
  const auto results = ClaimResultsOf(report);
  CHECK_FALSE(results[0].relived);
  CHECK_FALSE(results[0].IsRelivedFirst());
  REQUIRE(results[1].relived);
  CHECK(results[1].IsRelivedFirst());
  CHECK(results[1].relived->medians == std::vector<double>{88, 98});
  CHECK(results[1].relived->verdict == Verdict::kHolds);
  CHECK(results[1].recorded.verdict == Verdict::kOpposite);
  CHECK(*results[1].relived->holm == Approx(4.0 / 252));
  CHECK(ClaimsSummary(results) == "2 claims: 2 hold");

  // Of fewer runs they are told second, each family by itself.
  report.runs[0].relived.state = RelivedState::kMissing;
  const auto fewer = ClaimResultsOf(report);
  REQUIRE(fewer[1].relived);
  CHECK(fewer[1].relived->runs == std::vector<std::size_t>{4, 5});
  CHECK_FALSE(fewer[1].IsRelivedFirst());
  CHECK(fewer[1].first().verdict == Verdict::kOpposite);
  CHECK(*fewer[1].recorded.holm == Approx(4.0 / 252));
  CHECK(*fewer[1].relived->holm == Approx(2.0 / 126));
  CHECK(ClaimsSummary(fewer) == "2 claims: 1 holds, 1 opposite");
}

TEST_CASE("Runs that did not measure what is claimed are counted",
          "[claim_results]") {
  Claim seasons = SizeClaim(ClaimKind::kLess, "seasons");
  seasons.experiments = {"b"};
  seasons.seasons = {"flat", "tilted"};
  Claim value = SizeClaim(ClaimKind::kValue, "value");
  StudyReport report =
      ClaimedStudy({SizeClaim(ClaimKind::kGreater, "bigger"), seasons, value,
                    SizeClaim(ClaimKind::kEqual, "as big")});
  for (ReportRun& run : report.runs)
    for (Series& series : run.reading.population.series)
      series.means = series.best = {NAN, NAN};
  for (const ClaimResult& one : ClaimResultsOf(report)) {
    INFO(one.stated.claim.name);
    CHECK(one.completed == one.planned);
    for (const std::size_t runs : one.recorded.runs) CHECK(runs == 0);
    CHECK(one.first().verdict == Verdict::kTooFewRuns);
  }
}

TEST_CASE("A single run, and runs that are all the same, show nothing",
          "[claim_results]") {
  const std::vector<Claim> claims{SizeClaim(ClaimKind::kGreater, "bigger"),
                                  SizeClaim(ClaimKind::kEqual, "as big"),
                                  SizeClaim(ClaimKind::kValue, "value")};
  StudyReport one = ClaimedStudy(claims);
  for (std::size_t i = 1; i < one.runs.size(); ++i)
    one.runs[i].reading = RunReading();
  for (const ClaimResult& result : ClaimResultsOf(one)) {
    CHECK(result.recorded.runs[0] == 1);
    CHECK(result.first().verdict == Verdict::kTooFewRuns);
  }
  StudyReport same = ClaimedStudy(claims);
  for (ReportRun& run : same.runs)
    run.reading.population.series[0].means = {3, 3};
  const auto results = ClaimResultsOf(same);
  CHECK(results[0].first().verdict == Verdict::kNotShown);
  CHECK(results[0].first().p == 1);
  CHECK(results[0].first().effect->a == 0.5);
  CHECK(results[1].first().verdict == Verdict::kTooFewRuns);
}

TEST_CASE("A report reads the claims of a study's folder, and what they need",
          "[claim_results]") {
  const test::Scratch scratch;
  const std::string folder = scratch / "study";
  std::filesystem::copy(test::ReportedStudy::Get().folder, folder,
                        std::filesystem::copy_options::recursive);
  Study study = *StudyIn(folder);
  Claim claim = SizeClaim(ClaimKind::kGreater, "more limbs");
  claim.measure = "limbs";
  claim.experiments = {"plastic", "baseline"};
  study.claims = {claim};
  REQUIRE_FALSE(StateClaims(folder, study, "2026-11-30T12:00:00Z"));
  const StudyReport report =
      BuildReport(*FindRuns({folder}), *ChooseMeasures("speed"), {});
  CHECK(report.measures.back().id == "limbs");
  const auto results = ClaimResultsOf(report);
  REQUIRE(results.size() == 1);
  CHECK(WhenStated(report.claims[0].record[0]) ==
        "after 11 of 12 runs had begun (10 were done)");
  CHECK(results[0].is_early);
  CHECK(results[0].planned == std::vector<std::size_t>{3, 3});
  // A part of a study is no place for claims about the whole.
  CHECK(FindRuns({folder + "/plastic"})->claims.empty());
  test::WriteBytes(folder + "/claims.yaml", "stated: never\n");
  const auto inputs = FindRuns({folder});
  REQUIRE(inputs);
  CHECK(inputs->claims[0].problem.find("claims.yaml") != std::string::npos);
}

}  // namespace plsc
