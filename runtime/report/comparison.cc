// The unit of statistics is the run and not the robot: robots of a population
// are relatives. So each run gives one number a generation (its mean, or its
// best), curves are quartiles of these over runs, and tests compare the runs of
// two experiments, as the paper's do. Static references are shown and never
// tested. Pairs are tested within a measure and a season only.

#include "runtime/report/comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace plsc {

namespace {

/// A measure in a season of an experiment.
struct Cell {
  std::size_t measure = 0;
  std::size_t season = 0;  ///< as Report has it
  std::size_t experiment = 0;
  std::size_t own_season = 0;  ///< as the experiment's runs have it
};

std::vector<Cell> CellsOf(const StudyReport& report) {
  std::vector<Cell> cells;
  for (std::size_t measure = 0; measure < report.measures.size(); ++measure)
    for (std::size_t season = 0; season < report.seasons.size(); ++season)
      for (std::size_t i = 0; i < report.experiments.size(); ++i) {
        const std::vector<std::size_t>& own = report.experiments[i].seasons;
        const auto found = std::find(own.begin(), own.end(), season);
        if (found != own.end())
          cells.push_back({measure, season, i,
                           static_cast<std::size_t>(found - own.begin())});
      }
  return cells;
}

/// Nothing if the run was not read, or its store lacks the season.
const Series* SeriesOf(const StudyReport& report, std::size_t run,
                       const Cell& cell) {
  const PopulationSummary& population = report.runs[run].reading.population;
  return cell.own_season < population.seasons.size()
             ? &population.of(cell.measure, cell.own_season)
             : nullptr;
}

const std::vector<double>& ValuesOf(const Series& series, Counted of) {
  return of == Counted::kBest ? series.best : series.means;
}

double RecordedOfRun(const StudyReport& report, std::size_t run,
                     const Cell& cell, Counted of) {
  const Series* series = SeriesOf(report, run, cell);
  const auto generation = static_cast<std::size_t>(report.generation);
  if (series == nullptr || generation >= ValuesOf(*series, of).size())
    return std::numeric_limits<double>::quiet_NaN();
  return ValuesOf(*series, of)[generation];
}

double RelivedOfRun(const StudyReport& report, std::size_t run,
                    const Cell& cell, Counted of) {
  const RelivedReading& relived = report.runs[run].relived;
  const ReportMeasure& measure = report.measures[cell.measure];
  const std::vector<std::string>& known = RelivedMeasures();
  const auto found = std::find(known.begin(), known.end(), measure.id);
  if (found == known.end() || relived.state != RelivedState::kHere ||
      cell.own_season >= relived.generation.seasons)
    return std::numeric_limits<double>::quiet_NaN();
  const RelivedMeasure& one = relived.generation.of(
      static_cast<std::size_t>(found - known.begin()), cell.own_season);
  return measure.scale *
         (of == Counted::kBest ? one.best.quartiles.median : one.mean);
}

/// Of the generations of an experiment: what `values_at` finds, summarised.
template <typename ValuesAt>
void Summarise(const ValuesAt& values_at, std::vector<int>& counts,
               std::vector<Quartiles>& quartiles) {
  for (std::size_t generation = 0;; ++generation) {
    std::vector<double> values = values_at(generation);
    if (values.empty()) return;
    values.erase(std::remove_if(values.begin(), values.end(),
                                [](double value) { return std::isnan(value); }),
                 values.end());
    counts.push_back(static_cast<int>(values.size()));
    quartiles.push_back(QuartilesOf(std::move(values)));
  }
}

Curve CurveOf(const StudyReport& report, const Cell& cell, Counted of) {
  Curve curve{cell.measure, cell.season, cell.experiment, {}, {}, of};
  const std::vector<std::size_t>& runs =
      report.experiments[cell.experiment].runs;
  if (report.is_single && of == Counted::kMean) {
    if (const Series* series = SeriesOf(report, runs.front(), cell))
      curve.quartiles = series->spreads;
    curve.counts.assign(curve.quartiles.size(), 1);
    return curve;
  }
  Summarise(
      [&](std::size_t generation) {
        std::vector<double> values;
        for (const std::size_t run : runs)
          if (const Series* series = SeriesOf(report, run, cell))
            if (generation < ValuesOf(*series, of).size())
              values.push_back(ValuesOf(*series, of)[generation]);
        return values;
      },
      curve.counts, curve.quartiles);
  return curve;
}

/// Of the experiments with so many seasons.
std::vector<CensusCurves> CensusCurvesOf(const StudyReport& report,
                                         const std::vector<CensusPart>& parts,
                                         std::size_t least_seasons) {
  std::vector<CensusCurves> all;
  for (std::size_t i = 0; i < report.experiments.size(); ++i) {
    const ReportExperiment& one = report.experiments[i];
    if (one.seasons.size() < least_seasons) continue;
    CensusCurves curves{i, {}, {}};
    for (const CensusPart& part : parts) {
      curves.counts.clear();
      Summarise(
          [&](std::size_t generation) {
            std::vector<double> values;
            for (const std::size_t run : one.runs) {
              const auto& of = report.runs[run].reading.population.censuses;
              if (generation >= of.size()) continue;
              // A digest has not all of them.
              values.push_back(
                  of[generation].genotypes == 0
                      ? std::numeric_limits<double>::quiet_NaN()
                      : part.of(of[generation], one.experiment.population));
            }
            return values;
          },
          curves.counts, curves.parts.emplace_back());
    }
    if (!curves.counts.empty()) all.push_back(std::move(curves));
  }
  return all;
}

}  // namespace

std::vector<Curve> CurvesOf(const StudyReport& report, Counted of) {
  std::vector<Curve> curves;
  for (const Cell& cell : CellsOf(report)) {
    Curve curve = CurveOf(report, cell, of);
    if (std::any_of(
            curve.quartiles.begin(), curve.quartiles.end(),
            [](const Quartiles& one) { return !std::isnan(one.median); }))
      curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<Finals> FinalsOf(const StudyReport& report, Counted of, Told told) {
  std::vector<Finals> all;
  if (report.generation < 0) return all;
  for (const Cell& cell : CellsOf(report)) {
    Finals finals{cell.measure, cell.season, cell.experiment, {}, {}, of, told};
    std::vector<double> values;
    for (const std::size_t run : report.experiments[cell.experiment].runs) {
      const double value = told == Told::kRelived
                               ? RelivedOfRun(report, run, cell, of)
                               : RecordedOfRun(report, run, cell, of);
      if (std::isnan(value)) continue;
      finals.values.push_back({run, value});
      values.push_back(value);
    }
    if (values.empty()) continue;
    finals.box = BoxPlotOf(std::move(values));
    all.push_back(std::move(finals));
  }
  return all;
}

std::vector<Test> TestsOf(const StudyReport& report,
                          const std::vector<Finals>& finals) {
  const auto values_of = [](const Finals& one) {
    std::vector<double> values;
    for (const RunValue& value : one.values) values.push_back(value.value);
    return values;
  };
  const auto takes_part = [&](const Finals& one) {
    return !report.experiments[one.experiment].is_static &&
           one.values.size() >= 2;
  };
  std::vector<Test> tests;
  for (std::size_t i = 0; i < finals.size(); ++i)
    for (std::size_t j = i + 1; j < finals.size(); ++j) {
      const Finals& a = finals[i];
      const Finals& b = finals[j];
      if (a.measure != b.measure || a.season != b.season) break;
      if (!takes_part(a) || !takes_part(b)) continue;
      tests.push_back({a.measure, a.season, a.experiment, b.experiment,
                       a.values.size(), b.values.size(),
                       RankSumTest(values_of(a), values_of(b)), a.told});
    }
  return tests;
}

const std::vector<CensusPart>& DiversityParts() {
  using Counts = const CensusCounts&;
  static const std::vector<CensusPart> parts = {
      {"genotypes",
       [](Counts of, double) { return static_cast<double>(of.genotypes); }},
      {"phenotypes",
       [](Counts of, double) { return static_cast<double>(of.phenotypes); }},
      {"founders",
       [](Counts of, double) { return static_cast<double>(of.founders); }},
  };
  return parts;
}

const std::vector<CensusPart>& PlasticityParts() {
  using Counts = const CensusCounts&;
  static const std::vector<CensusPart> parts = {
      {"body",
       [](Counts of, double population) {
         return static_cast<double>(of.plastic_bodies) / population;
       }},
      {"brain_only",
       [](Counts of, double population) {
         return static_cast<double>(of.plastic_brains) / population;
       }},
      {"regulated",
       [](Counts of, double) {
         return static_cast<double>(of.regulated_rules) /
                static_cast<double>(of.rules);
       }},
      {"silent",
       [](Counts of, double) {
         return static_cast<double>(of.silent_rules) /
                static_cast<double>(of.rules);
       }},
  };
  return parts;
}

std::vector<CensusCurves> DiversityOf(const StudyReport& report) {
  return CensusCurvesOf(report, DiversityParts(), 1);
}

std::vector<CensusCurves> PlasticityOf(const StudyReport& report) {
  return CensusCurvesOf(report, PlasticityParts(), 2);
}

std::vector<ServoObedience> ObedienceOf(const StudyReport& report) {
  std::vector<ServoObedience> all;
  for (std::size_t i = 0; i < report.experiments.size(); ++i)
    for (std::size_t season = 0; season < report.experiments[i].seasons.size();
         ++season) {
      std::vector<double> medians;
      double worst = std::numeric_limits<double>::quiet_NaN();
      for (const std::size_t run : report.experiments[i].runs) {
        const auto& errors = report.runs[run].reading.population.errors;
        if (season >= errors.size() || std::isnan(errors[season].median))
          continue;
        medians.push_back(errors[season].median);
        worst = std::fmax(worst, errors[season].worst);
      }
      const int runs = static_cast<int>(medians.size());
      all.push_back(
          {i, season, runs, {QuartilesOf(std::move(medians)).median, worst}});
    }
  return all;
}

std::vector<RuleCount> RulesOf(const StudyReport& report,
                               std::size_t experiment) {
  std::vector<RuleCount> all;
  for (const std::size_t run : report.experiments[experiment].runs)
    AddRules(report.runs[run].reading.rules, all);
  return all;
}

}  // namespace plsc
