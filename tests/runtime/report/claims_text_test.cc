#include "runtime/report/claims_text.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/runtime/report/claimed_study.h"

namespace plsc {

TEST_CASE("Claims are told as text, each with what it rests on",
          "[claims_text]") {
  Claim bigger = test::SizeClaim(ClaimKind::kGreater, "big\x1b[2Jger");
  bigger.source = "Fig. 3";
  Claim seasons = test::SizeClaim(ClaimKind::kLess, "seasons");
  seasons.experiments = {"b"};
  seasons.seasons = {"flat", "tilted"};
  Claim value = test::SizeClaim(ClaimKind::kValue, "value");
  value.value = 12.5;
  Claim course = test::SizeClaim(ClaimKind::kMinimumBefore, "course");
  course.minimum_before = 2;
  StudyReport report = test::ClaimedStudy({bigger, seasons, value, course});
  report.runs[0].reading.state = RunState::kMissing;
  report.runs[0].reading.population = {};
  const std::string text = ClaimsText(report, ClaimResultsOf(report));
  INFO(text);
  CHECK(
      text ==
      R"(Claims, as 'plsc report' finds them in generation 1, before all runs are done

holds         big\x1b[2Jger
              Size: a > b, flat
              medians 12.5 and 2 modules of 4 + 5 runs (5 + 5 planned), ratio 6.25; A 1 (0.398 to 1), p 0.0159, 0.0317 by Holm of 2
              stated 2026-11-30T12:00:00Z before the first run
              source: Fig. 3

too few runs  seasons
              Size: flat < tilted, b
              medians 2 and 3 modules of 5 runs, ratio 0.667; A 0 (0 to 0.522), p 0.0625, 0.0625 by Holm of 2
              stated 2026-11-30T12:00:00Z before the first run

too few runs  value
              Size: a, flat: 12.5 modules
              median 12.5 modules of 4 runs (5 planned), published 12.5 modules, ratio 1
              stated 2026-11-30T12:00:00Z before the first run

too few runs  course
              Size: a, flat: lowest before generation 2
              lowest in generation -; so in 0 of 0 runs (5 planned, 4 without a whole curve)
              stated 2026-11-30T12:00:00Z before the first run

4 claims: 1 holds, 3 too few runs
)");
  CHECK(text.starts_with(kClaimsMark));
}

TEST_CASE("Text of claims says which values a verdict rests on, and of whom",
          "[claims_text]") {
  StudyReport report = test::RelivedClaims();
  const auto tells = [&](const std::string& part) {
    const std::string text = ClaimsText(report, ClaimResultsOf(report));
    INFO(text);
    CHECK(text.find(part) != std::string::npos);
  };
  tells("relived: medians 88 and 98 cm/s of 5 + 5 runs, ratio 0.898; A 0 ");
  tells("recorded (opposite): medians 12 and 2 cm/s of 5 + 5 runs, ratio 6;");
  report.runs[0].relived.state = RelivedState::kMissing;
  tells("opposite      slower\n");
  tells("recorded: medians 12 and 2 cm/s of 5 + 5 runs, ratio 6;");
  tells(
      "relived (holds): medians 87.5 and 98 cm/s of 4 + 5 runs (5 + 5 planned, "
      "1 + 0 not lived again)");
  for (ReportRun& run : report.runs) {
    run.relived.state = RelivedState::kMissing;
    run.reading.population.series[2].means = {NAN, NAN};
  }
  tells("too few runs  slower\n");
  tells(
      "medians - and - cm/s of 0 + 0 runs (5 + 5 planned, 5 + 5 not measured)");
}

}  // namespace plsc
