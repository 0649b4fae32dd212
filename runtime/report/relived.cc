// The unit is the robot's median and not its life: lives of one robot differ by
// chance, robots by what they are. Only lives that every robot of the
// generation has lived count (1, 2, ... without a gap), so that of a file that
// is being filled no robot counts with more chances than another, and what is
// told does not depend on the order in which workers answered.
//
// A swap compares lives that started alike: life n as it is and life n with the
// other body and brain are lifted equally. What a robot loses in a season is
// the median of its lives there less that of its lives with another season's
// phenotype (the mean of these medians, if there are several others).

#include "runtime/report/relived.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace plsc {

namespace {

int IndexOfSeason(std::size_t season) {
  return static_cast<int>(season);
}

/// Lives that all of these have.
int CommonLives(const RelivedMembers& members, const RelivedLives& lives) {
  int common = lives.CountOf({members.best});
  for (const int id : members.survivors)
    common = std::min(common, lives.CountOf({id}));
  return common;
}

/// Likewise of those that are swapped at all.
int CommonSwaps(const RelivedMembers& members, std::size_t seasons,
                const RelivedLives& lives) {
  int common = std::numeric_limits<int>::max();
  bool has_any = false;
  for (const int id : members.survivors)
    for (std::size_t season = 0; season < seasons; ++season)
      for (const int other : lives.SwapsOf(id, IndexOfSeason(season))) {
        has_any = true;
        common = std::min(
            common, lives.CountOf({id, false, IndexOfSeason(season), other}));
      }
  return has_any ? common : 0;
}

/// Of a measure in a season of `generation`, whose numbers of lives are known.
void AddSwaps(const RelivedLives& lives, const RelivedGeneration& generation,
              std::size_t measure, int season, RelivedMeasure& summary) {
  std::vector<double> own;
  std::vector<double> others;
  std::vector<double> losses;
  for (const auto& [id, values] : generation.robots) {
    const double mine =
        lives.ValueOf({id, false, season, season}, measure, generation.lives)
            .quartiles.median;
    std::vector<double> swapped;
    for (const int other : lives.SwapsOf(id, season)) {
      const double median =
          lives.ValueOf({id, false, season, other}, measure, generation.swaps)
              .quartiles.median;
      if (!std::isnan(median)) swapped.push_back(median);
    }
    const double theirs = MeanOf(swapped);
    if (std::isnan(mine) || std::isnan(theirs)) continue;
    own.push_back(mine);
    others.push_back(theirs);
    losses.push_back(mine - theirs);
  }
  summary.swapped = static_cast<int>(own.size());
  summary.own = MeanOf(own);
  summary.other = MeanOf(others);
  summary.losses = QuartilesOf(std::move(losses));
}

}  // namespace

RelivedLives::RelivedLives(std::vector<RelivedSeason> lives) {
  std::sort(lives.begin(), lives.end(),
            [](const RelivedSeason& a, const RelivedSeason& b) {
              return std::pair(a.of, a.n) < std::pair(b.of, b.n);
            });
  for (const RelivedSeason& life : lives) {
    if (groups_.empty() || groups_.back().of != life.of)
      groups_.push_back({life.of, {}, {}});
    groups_.back().n.push_back(life.n);
    groups_.back().measures.push_back(MeasuresOf(life.behaviour, life.fitness));
  }
}

const RelivedLives::Group* RelivedLives::Find(const LifeOf& of) const {
  const auto found =
      std::lower_bound(groups_.begin(), groups_.end(), of,
                       [](const Group& group, const LifeOf& wanted) {
                         return group.of < wanted;
                       });
  return found != groups_.end() && found->of == of ? &*found : nullptr;
}

RelivedValue RelivedLives::ValueOf(const LifeOf& of, std::size_t measure,
                                   int most) const {
  std::vector<double> values;
  if (const Group* group = Find(of))
    for (std::size_t i = 0; i < group->n.size() && group->n[i] <= most; ++i)
      if (const auto value = group->measures[i][measure])
        values.push_back(*value);
  return {static_cast<int>(values.size()), QuartilesOf(std::move(values))};
}

int RelivedLives::CountOf(const LifeOf& of) const {
  const Group* group = Find(of);
  int count = 0;
  if (group != nullptr)
    while (static_cast<std::size_t>(count) < group->n.size() &&
           group->n[static_cast<std::size_t>(count)] == count + 1)
      ++count;
  return count;
}

std::vector<int> RelivedLives::SwapsOf(int id, int season) const {
  std::vector<int> others;
  const LifeOf from{id, false, season, 0};
  auto group = std::lower_bound(
      groups_.begin(), groups_.end(), from,
      [](const Group& one, const LifeOf& wanted) { return one.of < wanted; });
  for (; group != groups_.end() && group->of.id == id &&
         !group->of.is_other_engine && group->of.season == season;
       ++group)
    if (group->of.is_swapped()) others.push_back(group->of.phenotype);
  return others;
}

RelivedGeneration SummariseRelived(const RelivedMembers& members,
                                   std::size_t seasons,
                                   const RelivedLives& lives) {
  RelivedGeneration generation;
  generation.generation = members.generation;
  generation.best = members.best;
  generation.survivors = static_cast<int>(members.survivors.size());
  generation.lives = CommonLives(members, lives);
  generation.swaps = CommonSwaps(members, seasons, lives);
  generation.other_lives = lives.CountOf({members.best, true});
  generation.seasons = seasons;
  for (const int id : members.survivors) generation.robots.push_back({id, {}});
  for (std::size_t measure = 0; measure < RelivedMeasures().size(); ++measure)
    for (std::size_t i = 0; i < seasons; ++i) {
      const int season = IndexOfSeason(i);
      RelivedMeasure summary;
      std::vector<double> medians;
      for (RelivedRobotValues& robot : generation.robots) {
        const RelivedValue value = lives.ValueOf(
            {robot.id, false, season, season}, measure, generation.lives);
        if (value.lives > 0) medians.push_back(value.quartiles.median);
        robot.values.push_back(value);
      }
      summary.mean = MeanOf(medians);
      summary.medians = QuartilesOf(std::move(medians));
      summary.best = lives.ValueOf({members.best, false, season, season},
                                   measure, generation.lives);
      summary.best_by_other =
          lives.ValueOf({members.best, true, season, season}, measure,
                        generation.other_lives);
      AddSwaps(lives, generation, measure, season, summary);
      generation.measures.push_back(summary);
    }
  return generation;
}

}  // namespace plsc
