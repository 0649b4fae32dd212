#pragma once

// Which robots of a run live again, how often and how, and what of that is not
// lived yet. A pure function of the run, the request and what is in the file,
// so that a killed process, a request for more lives and a run that has gone on
// are the same case: what is missing is lived.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/expected.h"
#include "grammar/failure.h"
#include "runtime/relive/relived_file.h"
#include "runtime/relive/relived_life.h"
#include "runtime/store/run_store.h"
#include "runtime/text/key.h"

namespace plsc {

struct GenerationChoice {
  enum class Kind : std::uint8_t { kLast, kAll, kEvery, kList };
  Kind kind = Kind::kLast;
  int every = 1;          ///< kEvery; the last one is always among them
  std::vector<int> list;  ///< kList

  /// Ascending, of so many completed ones; a failure names one that is not.
  Expected<std::vector<int>, Failure> Of(int completed) const;
};
/// "last", "all", "every 10", or numbers with commas between them.
Expected<GenerationChoice, Failure> ParseGenerations(std::string_view text);

struct ReliveRequest {
  GenerationChoice generations;
  int lives = 20;  ///< of each robot
  int swaps = 5;   ///< of each plastic robot in each season, at most `lives`
  /// The best robot of each generation by the other engine, `lives` times, too.
  bool is_engine_checked = false;
};

/// Who lives again for a generation.
struct RelivedMembers {
  int generation = 0;
  int best = 0;                ///< id; it need not have survived
  std::vector<int> survivors;  ///< ids, in the order of selection
};

struct RelivedRobot {
  std::int64_t checksum = 0;    ///< of its birth
  std::vector<Key> phenotypes;  ///< by season; zero: none developed
};

/// Of a run, before it is asked what is there already.
struct ReliveSubjects {
  RunIdentity run;
  std::vector<RelivedMembers> generations;  ///< that were chosen
  std::map<int, RelivedRobot> robots;       ///< all of these, by id
  /// Lives on from season to season are one, of which none can be swapped.
  bool is_swappable = true;

  RobotSums Sums() const;
};
Expected<std::vector<RelivedMembers>, Failure> MembersOf(
    RunStore& store, const std::vector<int>& generations);
Expected<ReliveSubjects, Failure> SubjectsOf(RunStore& store,
                                             const GenerationChoice& choice);

/// One life to be lived: all seasons, or one that is swapped (LifeOf).
struct LifeOrder {
  LifeOf of;  ///< of a life that is not swapped, its first season
  int n = 0;
};
/// In this order: one life of every robot, then another one of every robot, so
/// that what there is when somebody looks is as much of each; then those that
/// are swapped, season by season; then those by the other engine.
std::vector<LifeOrder> MissingLives(const ReliveSubjects& subjects,
                                    const ReliveRequest& request,
                                    const std::vector<RelivedSeason>& there);

/// The one that the run does not have: the articulated one if ODE lives any of
/// its seasons.
EngineKind OtherEngine(const Scenario& scenario);

/// Seasons whose phenotypes a plastic robot is given in `season`: each that it
/// does not have there, once.
std::vector<int> OtherPhenotypes(const std::vector<Key>& phenotypes,
                                 int season);

}  // namespace plsc
