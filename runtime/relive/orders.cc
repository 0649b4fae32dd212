#include "runtime/relive/orders.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "grammar/number.h"

namespace plsc {

namespace {

Failure NoSuchChoice(std::string_view text) {
  return fmt::format(
      "expected last, all, 'every N' or numbers of generations with commas "
      "between them, from 0; found '{}'",
      text);
}

/// What the file has of them. A worker's death says nothing of the robot, so
/// that life is lived anew, as in a run that goes on.
std::set<std::pair<LifeOf, int>> Known(
    const std::vector<RelivedSeason>& there) {
  std::set<std::pair<LifeOf, int>> known;
  std::set<std::pair<LifeOf, int>> dead;
  const auto first = [](LifeOf of) {
    if (!of.is_swapped()) of.season = of.phenotype = 0;
    return of;
  };
  for (const RelivedSeason& life : there)
    (life.outcome == Outcome::kWorkerDied ? dead : known)
        .insert({first(life.of), life.n});
  for (const auto& life : dead) known.erase(life);
  return known;
}

}  // namespace

Expected<GenerationChoice, Failure> ParseGenerations(std::string_view text) {
  using Kind = GenerationChoice::Kind;
  GenerationChoice choice;
  if (text == "last") return choice;
  choice.kind = Kind::kAll;
  if (text == "all") return choice;
  constexpr std::string_view kEvery = "every ";
  if (text.starts_with(kEvery)) {
    const auto step = ParseNumber<int>(text.substr(kEvery.size()));
    if (!step || *step < 1) return NoSuchChoice(text);
    choice.kind = Kind::kEvery;
    choice.every = *step;
    return choice;
  }
  choice.kind = Kind::kList;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto number = ParseNumber<int>(text.substr(begin, end - begin));
    if (!number || *number < 0) return NoSuchChoice(text);
    choice.list.push_back(*number);
    begin = end + 1;
  }
  return choice;
}

Expected<std::vector<int>, Failure> GenerationChoice::Of(int completed) const {
  if (completed == 0)
    return Failure("no generation is completed yet, so nobody survived");
  std::set<int> chosen;
  if (kind == Kind::kList)
    for (const int number : list) {
      if (number >= completed)
        return Failure(fmt::format(
            "there is no generation {}: {} are completed, from 0 to {}", number,
            completed, completed - 1));
      chosen.insert(number);
    }
  if (kind != Kind::kList) chosen.insert(completed - 1);
  const int step = kind == Kind::kAll ? 1 : every;
  if (kind == Kind::kAll || kind == Kind::kEvery)
    for (int number = 0; number < completed; number += step)
      chosen.insert(number);
  return std::vector<int>(chosen.begin(), chosen.end());
}

RobotSums ReliveSubjects::Sums() const {
  RobotSums sums;
  for (const auto& [id, robot] : robots) sums.emplace(id, robot.checksum);
  return sums;
}

Expected<std::vector<RelivedMembers>, Failure> MembersOf(
    RunStore& store, const std::vector<int>& generations) {
  std::vector<RelivedMembers> members;
  for (const int number : generations) {
    Expected<GenerationRecord, Failure> record = store.Generation(number);
    if (!record) return record.error();
    members.push_back({number, record->best, std::move(record->survivors)});
  }
  return members;
}

Expected<ReliveSubjects, Failure> SubjectsOf(RunStore& store,
                                             const GenerationChoice& choice) {
  ReliveSubjects subjects;
  Expected<RunIdentity, Failure> run = IdentityOf(store);
  if (!run) return run.error();
  subjects.run = std::move(*run);
  subjects.is_swappable =
      store.experiment().scenario.lives == Lives::kIndependent;
  const Expected<RunStatus, Failure> status = store.Status();
  if (!status) return status.error();
  const auto generations = choice.Of(status->generations);
  if (!generations)
    return Failure(
        fmt::format("'{}': {}", store.path(), generations.error().text));
  auto members = MembersOf(store, *generations);
  if (!members) return members.error();
  subjects.generations = std::move(*members);
  std::set<int> ids;
  for (const RelivedMembers& one : subjects.generations) {
    ids.insert(one.survivors.begin(), one.survivors.end());
    ids.insert(one.best);
  }
  for (const int id : ids) {
    const auto evidence = store.EvidenceOf(id);
    if (!evidence) return evidence.error();
    const auto checksum = store.ChecksumOfBirth(id);
    if (!checksum) return checksum.error();
    RelivedRobot& robot = subjects.robots[id];
    robot.checksum = *checksum;
    for (const SeasonEvidence& season : *evidence)
      robot.phenotypes.push_back(season.phenotype);
  }
  return subjects;
}

EngineKind OtherEngine(const Scenario& scenario) {
  return UsesOde(scenario) ? EngineKind::kArticulated : EngineKind::kOde;
}

std::vector<int> OtherPhenotypes(const std::vector<Key>& phenotypes,
                                 int season) {
  std::vector<int> others;
  const Key& own = phenotypes[static_cast<std::size_t>(season)];
  if (own == Key{}) return others;
  std::set<Key> seen = {own, Key{}};
  for (std::size_t i = 0; i < phenotypes.size(); ++i)
    if (seen.insert(phenotypes[i]).second)
      others.push_back(static_cast<int>(i));
  return others;
}

std::vector<LifeOrder> MissingLives(const ReliveSubjects& subjects,
                                    const ReliveRequest& request,
                                    const std::vector<RelivedSeason>& there) {
  const auto known = Known(there);
  std::vector<LifeOrder> missing;
  const auto order = [&](const LifeOf& of, int n) {
    if (!known.contains({of, n})) missing.push_back({of, n});
  };
  for (int n = 1; n <= request.lives; ++n)
    for (const auto& [id, robot] : subjects.robots) order({id}, n);
  const int seasons = static_cast<int>(subjects.run.seasons.size());
  const int swaps =
      subjects.is_swappable ? std::min(request.swaps, request.lives) : 0;
  for (int season = 0; season < seasons; ++season)
    for (int n = 1; n <= swaps; ++n)
      for (const auto& [id, robot] : subjects.robots)
        for (const int other : OtherPhenotypes(robot.phenotypes, season))
          order({id, false, season, other}, n);
  if (!request.is_engine_checked) return missing;
  std::set<int> best;
  for (const RelivedMembers& one : subjects.generations) best.insert(one.best);
  for (int n = 1; n <= request.lives; ++n)
    for (const int id : best) order({id, true}, n);
  return missing;
}

}  // namespace plsc
