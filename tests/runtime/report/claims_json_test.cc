#include "runtime/report/claims_json.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/runtime/report/claimed_study.h"

namespace plsc {

TEST_CASE("The JSON of a claim says what, since when, and what was found",
          "[claims_json]") {
  Claim value = test::SizeClaim(ClaimKind::kValue, "value");
  value.value = 12.5;
  Claim course = test::SizeClaim(ClaimKind::kMinimumBefore, "course");
  course.minimum_before = 2;
  StudyReport report = test::ClaimedStudy(
      {test::SizeClaim(ClaimKind::kGreater, "bigger"), value, course});
  ClaimsVersion later = report.claims[0].record[0];
  later.runs_begun = 3;
  later.claims.pop_back();
  report.claims[0].record.push_back(later);

  const auto json = ClaimsJson(report, ClaimResultsOf(report));
  REQUIRE(json.size() == 3);
  CHECK(json[0]["claim"] == "bigger");
  CHECK(json[0]["says"] == "a > b, flat");
  CHECK(json[0]["measure"] == "absolute_size");
  CHECK(json[0]["kind"] == "greater");
  CHECK(json[0]["verdict"] == "holds");
  CHECK(json[0]["relived"].is_null());
  CHECK(json[0]["told"] == "recorded");
  CHECK(json[0]["runs_completed"] == nlohmann::ordered_json{5, 5});
  CHECK(json[0]["withdrawn"].is_null());
  CHECK(json[0]["stated"]["when"] == "before the first run");
  const auto& found = json[0]["recorded"];
  CHECK(found["medians"] == nlohmann::ordered_json{12, 2});
  CHECK(found["ratio"] == 6);
  CHECK(found["a"] == 1);
  CHECK(found["interval"][1] == 1);
  CHECK(found["p"] == 0.00793651);
  CHECK(found["holm"] == 0.00793651);
  CHECK(found["exact"] == true);
  CHECK(json[1]["value"] == 12.5);
  CHECK(json[1]["recorded"]["ours"] == 12);
  CHECK(json[1]["recorded"]["interval"].is_null());  // of five runs
  CHECK(json[2]["withdrawn"]["version"] == 2);
  CHECK(json[2]["recorded"]["minimum"].is_null());
  CHECK(json[2]["recorded"]["medians"][0].is_null());

  const auto stated = ClaimsStatedJson(report);
  REQUIRE(stated.size() == 1);
  CHECK(stated[0]["versions"][1]["runs_begun"] == 3);
  CHECK(stated[0]["versions"][1]["claims"] == 2);
  report.claims[0] = {"x", {}, "broken"};
  CHECK(ClaimsStatedJson(report)[0]["problem"] == "broken");
  report.claims[0].problem.clear();
  CHECK(ClaimsStatedJson(report).empty());
}

}  // namespace plsc
