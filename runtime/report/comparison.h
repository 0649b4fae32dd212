#pragma once

// The numbers of a report's figures: curves over generations, the runs' means
// of one generation, tests between experiments. Each is of one measure in one
// season; pure functions of the report.

#include <cstdint>
#include <optional>
#include <vector>

#include "grammar/enum_names.h"
#include "runtime/report/report.h"
#include "runtime/report/wilcoxon.h"

namespace plsc {

/// Whose values a curve or a box is of: a run's population, or its best robot.
enum class Counted : std::uint8_t { kMean, kBest };

/// By whom: by the run, or by the lives that its robots lived again.
enum class Told : std::uint8_t { kRelived, kRecorded };
inline constexpr EnumNames<Told, 2> kToldNames{
    {{Told::kRelived, "relived"}, {Told::kRecorded, "recorded"}}};

/// By generation. Of several runs: quartiles of the population means, or of the
/// best robots, of those that have completed it. Of a single run: quartiles of
/// its population, and the best robot alone.
struct Curve {
  std::size_t measure = 0;
  std::size_t season = 0;  ///< index into StudyReport::seasons
  std::size_t experiment = 0;
  std::vector<int> counts;  ///< runs
  std::vector<Quartiles> quartiles;
  Counted of = Counted::kMean;
};
/// In the order of measures, seasons, experiments; only where an experiment
/// has the season and a run of it a value.
std::vector<Curve> CurvesOf(const StudyReport& report,
                            Counted of = Counted::kMean);

struct RunValue {
  std::size_t run = 0;  ///< index into StudyReport::runs
  double value = 0;
};
/// Population means, or values of the best robots, of the runs that have
/// completed the generation that is compared, in the shown unit. Of relived
/// ones: means of the robots' medians, or the best robots' medians.
struct Finals {
  std::size_t measure = 0;
  std::size_t season = 0;
  std::size_t experiment = 0;
  std::vector<RunValue> values;  ///< at least one
  BoxPlot box;
  Counted of = Counted::kMean;
  Told told = Told::kRecorded;
};
/// In the order of CurvesOf. Relived are measures of behaviour and the fitness
/// alone, of runs that have such lives.
std::vector<Finals> FinalsOf(const StudyReport& report,
                             Counted of = Counted::kMean,
                             Told told = Told::kRecorded);

/// Between two experiments that are not static, two runs or more of each.
struct Test {
  std::size_t measure = 0;
  std::size_t season = 0;
  std::size_t first = 0;  ///< indices into StudyReport::experiments
  std::size_t second = 0;
  std::size_t first_runs = 0;
  std::size_t second_runs = 0;
  std::optional<RankSum> result;  ///< nothing if all values are equal
  Told told = Told::kRecorded;
};
std::vector<Test> TestsOf(const StudyReport& report,
                          const std::vector<Finals>& finals);

/// A number of a census that is shown over generations.
struct CensusPart {
  const char* id;
  double (*of)(const CensusCounts& counts, double population);
};
/// How many are different: genotypes, phenotypes, founders.
const std::vector<CensusPart>& DiversityParts();
/// Shares from 0 to 1: of robots body, brain_only; of rules regulated, silent.
const std::vector<CensusPart>& PlasticityParts();

/// Of an experiment's populations, by generation: quartiles over runs.
struct CensusCurves {
  std::size_t experiment = 0;
  std::vector<int> counts;                    ///< runs
  std::vector<std::vector<Quartiles>> parts;  ///< in their order
};
/// Of all experiments; those with one season have no plasticity.
std::vector<CensusCurves> DiversityOf(const StudyReport& report);
std::vector<CensusCurves> PlasticityOf(const StudyReport& report);

/// How well servos did what they were told in a season of an experiment: the
/// median over its runs, and the worst of all.
struct ServoObedience {
  std::size_t experiment = 0;
  std::size_t season = 0;  ///< of the experiment's own
  int runs = 0;            ///< that have measured it
  SeasonErrors errors;
};
std::vector<ServoObedience> ObedienceOf(const StudyReport& report);

/// The rules of the last populations of an experiment's runs.
std::vector<RuleCount> RulesOf(const StudyReport& report,
                               std::size_t experiment);

}  // namespace plsc
