#include "runtime/report/claims_text.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "grammar/number.h"
#include "grammar/shown_line.h"

namespace plsc {

namespace {

constexpr int kIndent = 14;  // the widest verdict, and two blanks

/// Three digits, as tables of papers have.
std::string Digits(double value) {
  return std::isfinite(value) ? PrintRoundedNumber(value, 3) : "-";
}

std::string RangeText(const Interval& interval) {
  return fmt::format("{} to {}", Digits(interval.low), Digits(interval.high));
}

/// "20 + 20 runs", and how many are planned where not all are there.
std::string RunsText(const ClaimResult& result, const ClaimFinding& finding) {
  const auto joined = [&](const std::vector<std::size_t>& counts) {
    return finding.is_paired ? std::to_string(counts[0])
                             : fmt::format("{}", fmt::join(counts, " + "));
  };
  return joined(finding.runs) + " runs" +
         (finding.runs == result.planned
              ? ""
              : fmt::format(" ({} planned)", joined(result.planned)));
}

std::string RatioText(const ClaimFinding& finding) {
  return finding.ratio ? fmt::format(", ratio {}", Digits(*finding.ratio)) : "";
}

std::string TwoText(const ClaimResult& result, const ClaimFinding& finding,
                    const std::string& unit) {
  std::string text =
      fmt::format("medians {} and {}{} of {}{}", Digits(finding.medians[0]),
                  Digits(finding.medians[1]), unit, RunsText(result, finding),
                  RatioText(finding));
  if (!finding.effect) return text;
  text += fmt::format("; A {} ({})", Digits(finding.effect->a),
                      RangeText(finding.effect->interval));
  text += fmt::format(", p {}", Digits(*finding.p));
  if (finding.holm)
    text +=
        fmt::format(", {} by Holm of {}", Digits(*finding.holm), result.family);
  return text;
}

std::string OneText(const ClaimResult& result, const ClaimFinding& finding,
                    const std::string& unit) {
  const Claim& claim = result.stated.claim;
  if (claim.kind == ClaimKind::kMinimumBefore)
    return fmt::format(
        "lowest in generation {}; so in {} of {}{}",
        finding.minimum ? std::to_string(*finding.minimum) : "-",
        finding.runs_so, RunsText(result, finding),
        finding.interval
            ? fmt::format(" (a share of {})", RangeText(*finding.interval))
            : "");
  return fmt::format("{} {}{}{} of {}, published {}{}{}",
                     NameIn(kOverRunsNames, claim.over_runs),
                     finding.ours ? Digits(*finding.ours) : "-",
                     finding.interval
                         ? fmt::format(" ({})", RangeText(*finding.interval))
                         : "",
                     unit, RunsText(result, finding),
                     PrintPlainNumber(claim.value), unit, RatioText(finding));
}

std::string StatedText(const ClaimsRecord& record, const ClaimResult& result) {
  const auto at = [&](std::size_t version) {
    return fmt::format("{} {}", record[version].stated,
                       WhenStated(record[version]));
  };
  std::string text = "stated " + at(result.stated.since);
  if (result.stated.withdrawn)
    text += "; withdrawn " + at(*result.stated.withdrawn);
  return text;
}

std::string ResultText(const StudyReport& report, const ClaimResult& result) {
  const Claim& claim = result.stated.claim;
  const std::optional<ReportMeasure> measure = FindMeasure(claim.measure);
  const std::string unit =
      measure && !measure->unit.empty() ? " " + measure->unit : "";
  std::string text =
      fmt::format("{:{}}{}\n", NameIn(kVerdictNames, result.first().verdict),
                  kIndent, Escaped(claim.name));
  const auto add = [&](const std::string& line) {
    text += fmt::format("{:{}}{}\n", "", kIndent, Escaped(line));
  };
  add(fmt::format("{}{}: {}{}", measure ? measure->title : claim.measure,
                  claim.of == ClaimOf::kBest ? " of the best" : "",
                  WhatIsClaimed(claim),
                  claim.kind == ClaimKind::kValue ? unit : ""));
  const auto numbers = [&](const ClaimFinding& finding) {
    return IsOfTwo(claim.kind) ? TwoText(result, finding, unit)
                               : OneText(result, finding, unit);
  };
  if (result.relived) add("relived: " + numbers(*result.relived));
  add((result.relived
           ? fmt::format("recorded ({}): ",
                         NameIn(kVerdictNames, result.recorded.verdict))
           : "") +
      numbers(result.recorded));
  add(StatedText(report.claims[result.study].record, result));
  if (!claim.source.empty()) add("source: " + claim.source);
  return text;
}

}  // namespace

std::string ClaimsText(const StudyReport& report,
                       const std::vector<ClaimResult>& results) {
  bool is_early = false;
  for (const ClaimResult& result : results)
    is_early = is_early || result.is_early;
  std::string text =
      fmt::format("{}finds them{}{}\n\n", kClaimsMark,
                  report.generation < 0
                      ? ""
                      : fmt::format(" in generation {}", report.generation),
                  is_early ? ", before all runs are done" : "");
  for (const ClaimResult& result : results)
    text += ResultText(report, result) + "\n";
  return text + ClaimsSummary(results) + "\n";
}

}  // namespace plsc
