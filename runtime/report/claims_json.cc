#include "runtime/report/claims_json.h"

#include <optional>

#include "runtime/report/comparison.h"
#include "runtime/report/rounded_json.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

Json IntervalJson(const std::optional<Interval>& interval) {
  if (!interval) return nullptr;
  return {RoundedNumber(interval->low), RoundedNumber(interval->high)};
}

Json RoundedOrNull(const std::optional<double>& number) {
  return number ? RoundedNumber(*number) : Json(nullptr);
}

Json MediansJson(const std::vector<double>& medians) {
  Json json = Json::array();
  for (const double median : medians) json.push_back(RoundedNumber(median));
  return json;
}

Json FindingJson(const Claim& claim, const ClaimFinding& finding) {
  Json json{{"verdict", NameIn(kVerdictNames, finding.verdict)},
            {"runs", finding.runs},
            {"medians", MediansJson(finding.medians)}};
  if (claim.kind == ClaimKind::kMinimumBefore) {
    json["minimum"] = finding.minimum ? Json(*finding.minimum) : Json(nullptr);
    json["runs_so"] = finding.runs_so;
    json["interval"] = IntervalJson(finding.interval);
    return json;
  }
  json["ratio"] = RoundedOrNull(finding.ratio);
  if (claim.kind == ClaimKind::kValue) {
    json["ours"] = RoundedOrNull(finding.ours);
    json["interval"] = IntervalJson(finding.interval);
    return json;
  }
  const auto& effect = finding.effect;
  json["a"] = effect ? RoundedNumber(effect->a) : Json(nullptr);
  json["interval"] =
      IntervalJson(effect ? std::optional(effect->interval) : std::nullopt);
  json["paired"] = finding.is_paired;
  json["p"] = RoundedOrNull(finding.p);
  json["exact"] = finding.p ? Json(finding.is_exact) : Json(nullptr);
  json["holm"] = RoundedOrNull(finding.holm);
  return json;
}

Json VersionJson(const ClaimsRecord& record, std::size_t index) {
  const ClaimsVersion& version = record[index];
  return {{"version", index + 1},
          {"at", version.stated},
          {"when", WhenStated(version)},
          {"hash", version.hash},
          {"claims", version.claims.size()},
          {"runs", version.runs},
          {"runs_begun", version.runs_begun},
          {"runs_done", version.runs_done}};
}

Json ClaimJson(const StudyReport& report, const ClaimResult& result) {
  const Claim& claim = result.stated.claim;
  const StudyClaims& study = report.claims[result.study];
  const std::optional<ReportMeasure> measure = MeasureOf(report, claim);
  Json json{{"study", study.study},
            {"claim", claim.name},
            {"says", WhatIsClaimed(claim)},
            {"measure", measure ? Json(measure->id) : Json(nullptr)},
            {"of", NameIn(kClaimOfNames, claim.of)},
            {"kind", NameIn(kClaimKindNames, claim.kind)},
            {"experiments", claim.experiments},
            {"seasons", claim.seasons}};
  json["value"] = claim.kind == ClaimKind::kValue ? RoundedNumber(claim.value)
                                                  : Json(nullptr);
  json["over_runs"] = claim.kind == ClaimKind::kValue
                          ? Json(NameIn(kOverRunsNames, claim.over_runs))
                          : Json(nullptr);
  json["minimum_before"] = claim.kind == ClaimKind::kMinimumBefore
                               ? Json(claim.minimum_before)
                               : Json(nullptr);
  json["family"] = claim.family;
  json["source"] = claim.source;
  json["stated"] = VersionJson(study.record, result.stated.since);
  json["withdrawn"] = result.stated.withdrawn
                          ? VersionJson(study.record, *result.stated.withdrawn)
                          : Json(nullptr);
  json["runs_planned"] = result.planned;
  json["runs_completed"] = result.completed;
  json["early"] = result.is_early;
  json["corrected_among"] = result.family;
  json["verdict"] = NameIn(kVerdictNames, result.first().verdict);
  json["told"] = NameIn(
      kToldNames, result.IsRelivedFirst() ? Told::kRelived : Told::kRecorded);
  json["relived"] =
      result.relived ? FindingJson(claim, *result.relived) : Json(nullptr);
  json["recorded"] = FindingJson(claim, result.recorded);
  return json;
}

}  // namespace

Json ClaimsJson(const StudyReport& report,
                const std::vector<ClaimResult>& results) {
  Json json = Json::array();
  for (const ClaimResult& result : results)
    json.push_back(ClaimJson(report, result));
  return json;
}

Json ClaimsStatedJson(const StudyReport& report) {
  Json json = Json::array();
  for (const StudyClaims& study : report.claims) {
    if (study.record.empty() && study.problem.empty()) continue;
    Json versions = Json::array();
    for (std::size_t i = 0; i < study.record.size(); ++i)
      versions.push_back(VersionJson(study.record, i));
    json.push_back({{"study", study.study},
                    {"problem", study.problem.empty() ? Json(nullptr)
                                                      : Json(study.problem)},
                    {"versions", std::move(versions)}});
  }
  return json;
}

}  // namespace plsc
