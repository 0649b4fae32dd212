// A claim is about experiments of its own study, by name, and so are its
// values: of each run of these its number in the generation that is compared,
// as the box plots have it (comparison.h). Each claim draws its bootstrap from
// a stream that is named by its text, so that no other claim changes its
// interval.
//
// Corrected together are the greater and the less of one family, all that were
// ever stated: their verdicts rest on p. Those of equal do not. A family is
// corrected twice: of what is told first, where bodies and brains, which no
// other life changes, stand beside relived behaviour; and of what is not, where
// a claim that has nothing else stands with the same p.

#include "runtime/report/claim_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "grammar/number.h"
#include "runtime/report/comparison.h"
#include "runtime/report/holm.h"
#include "runtime/text/key.h"
#include "runtime/vary/rng.h"

namespace plsc {

namespace {

// Any; the same for all reports.
constexpr std::uint64_t kBootstrapSeed = 17;

/// What a claim names in the report.
struct ClaimCell {
  std::size_t measure = 0;
  std::string experiment, season;
  Counted of = Counted::kMean;
  Told told = Told::kRecorded;
};

class ClaimReader {
 public:
  explicit ClaimReader(const StudyReport& report) : report_(report) {
    for (const Counted of : {Counted::kMean, Counted::kBest})
      for (const Told told : {Told::kRelived, Told::kRecorded})
        for (Finals& finals : FinalsOf(report, of, told))
          finals_.push_back(std::move(finals));
  }

  ClaimResult Read(std::size_t study, const StatedClaim& stated) const {
    ClaimResult result{study, stated, {}, {}, false, 1, {}, {}};
    const Claim& claim = stated.claim;
    for (const std::string& experiment : claim.experiments)
      CountPlanned(study, experiment, result);
    if (claim.seasons.size() > 1) {
      result.planned.push_back(result.planned[0]);
      result.completed.push_back(result.completed[0]);
    }
    result.recorded = Find(study, claim, Told::kRecorded);
    ClaimFinding relived = Find(study, claim, Told::kRelived);
    if (std::all_of(relived.runs.begin(), relived.runs.end(),
                    [](std::size_t runs) { return runs > 0; }))
      result.relived = std::move(relived);
    return result;
  }

 private:
  ClaimFinding Find(std::size_t study, const Claim& claim, Told told) const {
    const std::vector<ClaimCell> cells = CellsOfClaim(claim, told);
    Rng rng({kBootstrapSeed, 0, KeyOf(PrintClaims({claim}, 0)).high,
             Purpose::kBootstrap});
    if (claim.kind == ClaimKind::kMinimumBefore)
      return FindingOfCourse(
          CurvesOfRuns(study, cells[0], claim.minimum_before),
          claim.minimum_before);
    if (claim.kind == ClaimKind::kValue)
      return FindingOfValue(Values(study, cells[0]), claim.value,
                            claim.over_runs, rng);
    return Compare(study, cells, rng);
  }

  std::vector<ClaimCell> CellsOfClaim(const Claim& claim, Told told) const {
    const auto measure =
        std::find_if(report_.measures.begin(), report_.measures.end(),
                     [&](const ReportMeasure& one) {
                       return MeasureName(one) == claim.measure;
                     });
    const auto index =
        static_cast<std::size_t>(measure - report_.measures.begin());
    const Counted of =
        claim.of == ClaimOf::kBest ? Counted::kBest : Counted::kMean;
    std::vector<ClaimCell> cells;
    for (const std::string& experiment : claim.experiments)
      for (const std::string& season : claim.seasons)
        cells.push_back({index, experiment, season, of, told});
    return cells;
  }

  bool IsOf(std::size_t run, std::size_t study,
            const std::string& experiment) const {
    const ReportInput& input = report_.runs[run].input;
    return input.study == study && input.experiment == experiment;
  }

  void CountPlanned(std::size_t study, const std::string& experiment,
                    ClaimResult& result) const {
    std::size_t planned = 0;
    std::size_t completed = 0;
    for (std::size_t run = 0; run < report_.runs.size(); ++run) {
      if (!IsOf(run, study, experiment)) continue;
      const RunReading& reading = report_.runs[run].reading;
      ++planned;
      if (reading.state != RunState::kDone) result.is_early = true;
      if (report_.generation >= 0 &&
          reading.population.generations > report_.generation)
        ++completed;
    }
    result.planned.push_back(planned);
    result.completed.push_back(completed);
  }

  /// By run.
  std::map<std::size_t, double> ValuesByRun(std::size_t study,
                                            const ClaimCell& cell) const {
    std::map<std::size_t, double> values;
    for (const Finals& finals : finals_) {
      if (finals.measure != cell.measure || finals.of != cell.of ||
          finals.told != cell.told)
        continue;
      const ReportExperiment& one = report_.experiments[finals.experiment];
      const auto& seasons = one.experiment.scenario.seasons;
      for (std::size_t i = 0; i < seasons.size(); ++i)
        if (seasons[i].name == cell.season && one.seasons[i] == finals.season)
          for (const RunValue& value : finals.values)
            if (IsOf(value.run, study, cell.experiment))
              values[value.run] = value.value;
    }
    return values;
  }

  std::vector<double> Values(std::size_t study, const ClaimCell& cell) const {
    std::vector<double> values;
    for (const auto& [run, value] : ValuesByRun(study, cell))
      values.push_back(value);
    return values;
  }

  ClaimFinding Compare(std::size_t study, const std::vector<ClaimCell>& cells,
                       Rng& rng) const {
    const bool is_paired = cells[0].experiment == cells[1].experiment;
    if (!is_paired)
      return FindingOfTwo(Values(study, cells[0]), Values(study, cells[1]),
                          false, rng);
    std::vector<double> x;
    std::vector<double> y;
    const auto second = ValuesByRun(study, cells[1]);
    for (const auto& [run, value] : ValuesByRun(study, cells[0]))
      if (const auto other = second.find(run); other != second.end()) {
        x.push_back(value);
        y.push_back(other->second);
      }
    return FindingOfTwo(x, y, true, rng);
  }

  /// Up to the generation that is compared, which is one that a minimum before
  /// `before` can be told in, of those that completed it.
  std::vector<std::vector<double>> CurvesOfRuns(std::size_t study,
                                                const ClaimCell& cell,
                                                int before) const {
    std::vector<std::vector<double>> curves;
    // Only the last generations live again.
    if (report_.generation < before || cell.told == Told::kRelived)
      return curves;
    const auto count = static_cast<std::size_t>(report_.generation) + 1;
    for (std::size_t run = 0; run < report_.runs.size(); ++run) {
      const PopulationSummary& population =
          report_.runs[run].reading.population;
      if (!IsOf(run, study, cell.experiment)) continue;
      for (std::size_t i = 0; i < population.seasons.size(); ++i) {
        if (population.seasons[i] != cell.season) continue;
        const Series& series = population.of(cell.measure, i);
        const std::vector<double>& values =
            cell.of == Counted::kBest ? series.best : series.means;
        if (values.size() < count) continue;
        std::vector<double> curve(
            values.begin(),
            values.begin() + static_cast<std::ptrdiff_t>(count));
        // A minimum may lie in a gap, as digests have.
        if (std::none_of(curve.begin(), curve.end(),
                         [](double value) { return std::isnan(value); }))
          curves.push_back(std::move(curve));
      }
    }
    return curves;
  }

  const StudyReport& report_;
  std::vector<Finals> finals_;
};

bool IsCorrected(const ClaimResult& result) {
  return result.stated.claim.kind == ClaimKind::kGreater ||
         result.stated.claim.kind == ClaimKind::kLess;
}

using Family = std::vector<ClaimResult*>;

void JudgeFamily(const Family& family) {
  std::vector<std::optional<double>> first;
  std::vector<std::optional<double>> second;
  for (const ClaimResult* result : family) {
    first.push_back(result->first().p);
    second.push_back(result->IsRelivedFirst() || !result->relived
                         ? result->recorded.p
                         : result->relived->p);
  }
  const auto adjusted = HolmAdjusted(first);
  const auto others = HolmAdjusted(second);
  for (std::size_t i = 0; i < family.size(); ++i) {
    const bool is_relived_first = family[i]->IsRelivedFirst();
    family[i]->family = family.size();
    family[i]->recorded.holm = is_relived_first ? others[i] : adjusted[i];
    if (family[i]->relived)
      family[i]->relived->holm = is_relived_first ? adjusted[i] : others[i];
  }
}

void Judge(std::vector<ClaimResult>& results) {
  std::map<std::pair<std::size_t, std::string>, Family> families;
  for (ClaimResult& result : results)
    if (IsCorrected(result))
      families[{result.study, result.stated.claim.family}].push_back(&result);
  for (const auto& [name, family] : families) JudgeFamily(family);
  for (ClaimResult& result : results) {
    const ClaimKind kind = result.stated.claim.kind;
    if (!IsOfTwo(kind)) continue;
    JudgeOfTwo(kind, result.family, result.recorded);
    if (result.relived) JudgeOfTwo(kind, result.family, *result.relived);
  }
}

}  // namespace

bool ClaimResult::IsRelivedFirst() const {
  return relived && std::equal(relived->runs.begin(), relived->runs.end(),
                               recorded.runs.begin(), std::greater_equal<>());
}

std::vector<ClaimResult> ClaimResultsOf(const StudyReport& report) {
  std::vector<ClaimResult> results;
  if (report.claims.empty()) return results;
  const ClaimReader reader(report);
  for (std::size_t study = 0; study < report.claims.size(); ++study)
    for (const StatedClaim& stated : StatedClaims(report.claims[study].record))
      results.push_back(reader.Read(study, stated));
  Judge(results);
  return results;
}

std::optional<ReportMeasure> MeasureOf(const StudyReport& report,
                                       const Claim& claim) {
  std::optional<ReportMeasure> known = FindMeasure(claim.measure);
  if (known)
    for (const ReportMeasure& shown : report.measures)
      if (shown.id == known->id) return shown;
  return known;
}

std::string ClaimsSummary(const std::vector<ClaimResult>& results) {
  if (results.empty()) return "";
  std::string text =
      fmt::format("{} claim{}", results.size(), results.size() == 1 ? "" : "s");
  const char* separator = ": ";
  for (const auto& [verdict, name] : kVerdictNames) {
    const auto count =
        std::count_if(results.begin(), results.end(),
                      [wanted = verdict](const ClaimResult& one) {
                        return one.first().verdict == wanted;
                      });
    if (count == 0) continue;
    const bool is_many = verdict == Verdict::kHolds && count > 1;
    text += fmt::format("{}{} {}", separator, count, is_many ? "hold" : name);
    separator = ", ";
  }
  return text;
}

std::string WhatIsClaimed(const Claim& claim) {
  const char* sign = claim.kind == ClaimKind::kGreater ? ">"
                     : claim.kind == ClaimKind::kLess  ? "<"
                                                       : "=";
  if (claim.experiments.size() == 2)
    return fmt::format("{} {} {}, {}", claim.experiments[0], sign,
                       claim.experiments[1], claim.seasons[0]);
  if (claim.seasons.size() == 2)
    return fmt::format("{} {} {}, {}", claim.seasons[0], sign, claim.seasons[1],
                       claim.experiments[0]);
  const std::string where =
      fmt::format("{}, {}", claim.experiments[0], claim.seasons[0]);
  if (claim.kind == ClaimKind::kMinimumBefore)
    return fmt::format("{}: lowest before generation {}", where,
                       claim.minimum_before);
  return fmt::format("{}: {}", where, PrintPlainNumber(claim.value));
}

}  // namespace plsc
