#include "runtime/study/claim.h"

#include <fmt/format.h>

#include <optional>

#include "grammar/number.h"
#include "runtime/study/report_measures.h"
#include "runtime/text/yaml_text.h"

namespace plsc {

namespace {

std::string PairText(const std::vector<std::string>& pair) {
  return fmt::format("[{}, {}]", PrintYamlText(pair[0]),
                     PrintYamlText(pair[1]));
}

/// What the key of its kind says.
std::string KindText(const Claim& claim) {
  if (claim.kind == ClaimKind::kMinimumBefore)
    return std::to_string(claim.minimum_before);
  if (claim.kind == ClaimKind::kValue) {
    const std::optional<ReportMeasure> measure = FindMeasure(claim.measure);
    const std::string unit = measure ? measure->unit : "";
    return PrintPlainNumber(claim.value) + (unit.empty() ? "" : " " + unit);
  }
  return PairText(claim.experiments.size() == 2 ? claim.experiments
                                                : claim.seasons);
}

}  // namespace

std::string PrintClaims(const std::vector<Claim>& claims, int indent) {
  std::string text;
  const auto line = [&](int depth, std::string_view key,
                        const std::string& value) {
    text += fmt::format("{:{}}{}:{}{}\n", "", indent + depth, key,
                        value.empty() ? "" : " ", value);
  };
  for (const Claim& claim : claims) {
    line(0, PrintYamlText(claim.name), "");
    line(2, "measure", PrintYamlText(claim.measure));
    if (claim.of != ClaimOf::kMean)
      line(2, "of", std::string(NameIn(kClaimOfNames, claim.of)));
    if (claim.seasons.size() == 1)
      line(2, "season", PrintYamlText(claim.seasons[0]));
    if (claim.experiments.size() == 1)
      line(2, "experiment", PrintYamlText(claim.experiments[0]));
    line(2, NameIn(kClaimKindNames, claim.kind), KindText(claim));
    if (claim.over_runs != OverRuns::kMedian)
      line(2, "over_runs",
           std::string(NameIn(kOverRunsNames, claim.over_runs)));
    if (!claim.family.empty()) line(2, "family", PrintYamlText(claim.family));
    if (!claim.source.empty()) line(2, "source", PrintYamlText(claim.source));
  }
  return text;
}

}  // namespace plsc
