#include "runtime/cli/commands/replay_compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/develop/descriptors.h"
#include "runtime/life/season_result.h"

namespace plsc::cli {

namespace {

class SeasonComparison {
 public:
  SeasonComparison(const std::string& season, Replayed& replayed)
      : season_(season), replayed_(replayed) {}

  void Add(std::string_view name, const std::string& stored,
           const std::string& now) {
    ++replayed_.values;
    if (stored != now)
      replayed_.differences.push_back(
          {season_, std::string(name), stored, now});
  }
  // The shortest text that reads back equal, so equal texts are equal bits.
  void Add(std::string_view name, double stored, double now) {
    Add(name, fmt::format("{}", stored + 0.0), fmt::format("{}", now + 0.0));
  }
  void Add(std::string_view name, const std::optional<double>& stored,
           const std::optional<double>& now) {
    const auto text = [](const std::optional<double>& value) {
      return value ? fmt::format("{}", *value + 0.0) : std::string("none");
    };
    Add(name, text(stored), text(now));
  }
  void Add(const std::vector<NamedValue>& stored,
           const std::vector<NamedValue>& now) {
    for (std::size_t i = 0; i < stored.size(); ++i)
      Add(stored[i].name, stored[i].value, now[i].value);
  }
  // A store of before lacks some.
  void AddKnown(const std::vector<NamedValue>& stored,
                const std::vector<NamedValue>& now) {
    for (std::size_t i = 0; i < stored.size(); ++i)
      if (!std::isnan(stored[i].value))
        Add(stored[i].name, stored[i].value, now[i].value);
  }

 private:
  const std::string& season_;
  Replayed& replayed_;
};

std::string TextOf(const std::vector<SensedState>& sensed) {
  std::string text;
  for (const SensedState& state : sensed)
    text += fmt::format("{}={} ({}) ", state.name, state.value,
                        NameIn(kSenseSourceNames, state.from));
  return text;
}

void CompareSeasons(const SeasonResult& stored, const SeasonResult& now,
                    SeasonComparison& comparison) {
  comparison.Add("sensed", TextOf(stored.sensed), TextOf(now.sensed));
  comparison.Add("inclination", stored.inclination, now.inclination);
  comparison.Add("begin", stored.begin, now.begin);
  comparison.Add("change", std::string(NameIn(kChangeNames, stored.change)),
                 std::string(NameIn(kChangeNames, now.change)));
  comparison.Add("change_reason", stored.change_reason, now.change_reason);
  comparison.Add("outcome", std::string(OutcomeName(stored.outcome)),
                 std::string(OutcomeName(now.outcome)));
  comparison.Add("reason", stored.reason, now.reason);
  comparison.Add("fitness", stored.fitness, now.fitness);
  comparison.Add(List(stored.body), List(now.body));
  comparison.Add(List(stored.brain), List(now.brain));
  comparison.AddKnown(List(stored.behaviour), List(now.behaviour));
  comparison.Add("state_hash", fmt::format("{:016x}", stored.state_hash),
                 fmt::format("{:016x}", now.state_hash));
  comparison.Add("steps", fmt::format("{}", stored.steps),
                 fmt::format("{}", now.steps));
  comparison.Add("solver_warnings", fmt::format("{}", stored.solver_warnings),
                 fmt::format("{}", now.solver_warnings));
}

}  // namespace

Replayed Compare(const Individual& stored,
                 const std::vector<SeasonEvidence>& evidence,
                 const EvaluatedLife& now, bool with_keys) {
  Replayed replayed;
  replayed.id = stored.id;
  const auto& seasons = stored.evaluation.seasons;
  replayed.seasons = seasons.size();
  for (std::size_t i = 0; i < seasons.size(); ++i) {
    SeasonComparison comparison(seasons[i].season, replayed);
    CompareSeasons(seasons[i], now.evaluation.seasons[i], comparison);
    const SeasonEvidence& before = evidence[i];
    const SeasonEvidence& after = now.evidence[i];
    comparison.Add("body", before.body, after.body);
    comparison.Add("brain", before.brain, after.brain);
    comparison.Add("phenotype", Hex(before.phenotype), Hex(after.phenotype));
    if (with_keys)
      comparison.Add("simulation", Hex(before.simulation),
                     Hex(after.simulation));
  }
  return replayed;
}

}  // namespace plsc::cli
