// A digest keeps what statistics are made of, the runs' means and their best
// robots by generation and what these did when they lived again, and drops what
// only looks further: robots, portraits, rules. Numbers have six digits and
// generations are thinned out, so that a run of the paper is 7 KB, 3 of them
// the genotype; the last generation, which is compared, is always kept. Between
// generations that were kept there is no number, as where no robot has a value.

#include "runtime/report/digest.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "compiler/print.h"
#include "runtime/store/run_store.h"
#include "runtime/study/study_folder.h"

namespace plsc {

namespace {

auto PlaceOf(const StudyRun& run) {
  return std::tuple(run.experiment, run.repetition);
}

Expected<std::string, Failure> GenotypeOf(const std::string& path, int id) {
  RunStore store;
  if (auto failure = store.OpenForReading(path)) return *failure;
  const Expected<Individual, Failure> robot = store.Find(id);
  if (!robot) return robot.error();
  return Print(robot->genotype);
}

/// Made by programs of the same results, and so the same robots.
bool AreSameResults(const DigestRun& one, const DigestRun& other) {
  return one.reading.facts.versions.results ==
             other.reading.facts.versions.results &&
         one.reading.facts.best == other.reading.facts.best &&
         one.genotype == other.genotype;
}

}  // namespace

bool IsKept(int generation, int generations, int every) {
  return generation % every == 0 || generation == generations - 1;
}

Expected<std::optional<DigestRun>, Failure> DigestOf(const std::string& folder,
                                                     const Digest& digest,
                                                     const StudyRun& run) {
  const std::string path = RunPath(folder, digest.study, run);
  DigestRun one{run, "",
                ReadRun(path, {digest.measures, false, false},
                        ExperimentOf(digest.study, run))};
  if (one.reading.state == RunState::kDamaged)
    return Failure(one.reading.problem);
  if (one.reading.state != RunState::kDone) return std::optional<DigestRun>();
  Expected<std::string, Failure> genotype =
      GenotypeOf(path, one.reading.facts.best);
  if (!genotype) return genotype.error();
  one.genotype = std::move(*genotype);
  RelivedReading relived =
      ReadRelived(path, one.reading.population.generations - 1);
  if (relived.state == RelivedState::kUnusable) return Failure(relived.problem);
  if (relived.state == RelivedState::kHere) one.relived = std::move(relived);
  return std::optional(std::move(one));
}

RunReading ReadingOf(const Digest& digest, const DigestRun& run,
                     const std::vector<ReportMeasure>& measures) {
  RunReading reading = run.reading;
  PopulationSummary& population = reading.population;
  population.series.clear();
  const std::vector<double> none(
      static_cast<std::size_t>(population.generations),
      std::numeric_limits<double>::quiet_NaN());
  for (const ReportMeasure& measure : measures) {
    const auto found =
        std::find(digest.measures.begin(), digest.measures.end(), measure);
    for (std::size_t season = 0; season < population.seasons.size(); ++season)
      population.series.push_back(
          found == digest.measures.end()
              ? Series{none, {}, none}
              : run.reading.population.of(
                    static_cast<std::size_t>(found - digest.measures.begin()),
                    season));
  }
  return reading;
}

void AddRun(DigestRun run, Digest& digest) {
  const auto place =
      std::lower_bound(digest.runs.begin(), digest.runs.end(), PlaceOf(run.run),
                       [](const DigestRun& one, const auto& wanted) {
                         return PlaceOf(one.run) < wanted;
                       });
  if (place == digest.runs.end() || !(place->run == run.run)) {
    digest.runs.insert(place, std::move(run));
    return;
  }
  if (run.relived.state != RelivedState::kHere && AreSameResults(*place, run))
    run.relived = std::move(place->relived);
  *place = std::move(run);
}

std::string CommandFor(const Study& study, const StudyRun& run) {
  return fmt::format("plsc study run study.yaml -o study --only {}",
                     RunName(study, run));
}

}  // namespace plsc
