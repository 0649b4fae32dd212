#include "runtime/report/claims_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "grammar/number.h"
#include "grammar/shown_line.h"
#include "runtime/report/comparison.h"

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

/// What is told, of one of a claim's findings.
struct Telling {
  const ClaimResult& result;
  const ClaimFinding& finding;
  std::string unit;  // with a blank before it; or empty
  Told told;
};

/// Why runs that are there have no value.
const char* WhyNone(const Telling& telling) {
  if (telling.told == Told::kRelived) return "not lived again";
  return telling.result.stated.claim.kind == ClaimKind::kMinimumBefore
             ? "without a whole curve"
             : "not measured";
}

/// "20 + 20 runs", how many are planned where not all are there, and how many
/// are there without a value.
std::string RunsText(const Telling& telling) {
  const ClaimFinding& finding = telling.finding;
  const auto joined = [&](const std::vector<std::size_t>& counts) {
    return finding.is_paired ? std::to_string(counts[0])
                             : fmt::format("{}", fmt::join(counts, " + "));
  };
  std::string text = joined(finding.runs) + " runs";
  if (finding.runs == telling.result.planned) return text;
  text += fmt::format(" ({} planned", joined(telling.result.planned));
  const std::vector<std::size_t>& completed = telling.result.completed;
  std::vector<std::size_t> without;
  for (std::size_t i = 0; i < finding.runs.size(); ++i)
    without.push_back(completed[i] - std::min(completed[i], finding.runs[i]));
  if (finding.runs != completed)
    text += fmt::format(", {} {}", joined(without), WhyNone(telling));
  return text + ")";
}

std::string RatioText(const ClaimFinding& finding) {
  return finding.ratio ? fmt::format(", ratio {}", Digits(*finding.ratio)) : "";
}

std::string TwoText(const Telling& telling) {
  const ClaimFinding& finding = telling.finding;
  std::string text =
      fmt::format("medians {} and {}{} of {}{}", Digits(finding.medians[0]),
                  Digits(finding.medians[1]), telling.unit, RunsText(telling),
                  RatioText(finding));
  if (!finding.effect) return text;
  text += fmt::format("; A {} ({})", Digits(finding.effect->a),
                      RangeText(finding.effect->interval));
  text += fmt::format(", p {}", Digits(*finding.p));
  if (finding.holm)
    text += fmt::format(", {} by Holm of {}", Digits(*finding.holm),
                        telling.result.family);
  return text;
}

std::string OneText(const Telling& telling) {
  const ClaimFinding& finding = telling.finding;
  const Claim& claim = telling.result.stated.claim;
  if (claim.kind == ClaimKind::kMinimumBefore)
    return fmt::format(
        "lowest in generation {}; so in {} of {}{}",
        finding.minimum ? std::to_string(*finding.minimum) : "-",
        finding.runs_so, RunsText(telling),
        finding.interval
            ? fmt::format(" (a share of {})", RangeText(*finding.interval))
            : "");
  return fmt::format(
      "{} {}{}{} of {}, published {}{}{}",
      NameIn(kOverRunsNames, claim.over_runs),
      finding.ours ? Digits(*finding.ours) : "-",
      finding.interval ? fmt::format(" ({})", RangeText(*finding.interval))
                       : "",
      telling.unit, RunsText(telling), PrintPlainNumber(claim.value),
      telling.unit, RatioText(finding));
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
  const std::optional<ReportMeasure> measure = MeasureOf(report, claim);
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
  const auto tell = [&](const std::string& begin, Told told) {
    const ClaimFinding& finding =
        told == Told::kRelived ? *result.relived : result.recorded;
    const Telling telling{result, finding, unit, told};
    add(begin + (IsOfTwo(claim.kind) ? TwoText(telling) : OneText(telling)));
  };
  if (!result.relived) {
    tell("", Told::kRecorded);
  } else {
    const bool is_relived = result.IsRelivedFirst();
    const Told first = is_relived ? Told::kRelived : Told::kRecorded;
    const Told other = is_relived ? Told::kRecorded : Told::kRelived;
    tell(fmt::format("{}: ", NameIn(kToldNames, first)), first);
    tell(fmt::format(
             "{} ({}): ", NameIn(kToldNames, other),
             NameIn(kVerdictNames, is_relived ? result.recorded.verdict
                                              : result.relived->verdict)),
         other);
  }
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
