// What is sensed in a season follows from the scenario but for one thing: in a
// continuous life the ground may feel otherwise where the robot has come to. On
// level ground it cannot; elsewhere both answers are possible, and
// PossibleEnvironments has both, by way of an inclination of nothing and one
// beyond every threshold.

#include "runtime/life/season_environments.h"

#include <cstddef>
#include <numbers>
#include <optional>

#include "runtime/life/season_developer.h"
#include "sim/imu.h"
#include "sim/placement.h"

namespace plsc {

namespace {

double FeltAtStart(const Scenario& scenario, const Season& season) {
  return FeltInclination(season.terrain, OptionsFor(scenario, season),
                         scenario.imu, {});
}

/// Whether a robot may feel the ground otherwise where it has come to. Level
/// ground is the same everywhere.
bool HangsOnPlace(const Scenario& scenario, std::size_t season) {
  return scenario.lives == Lives::kContinuous && season > 0 &&
         scenario.seasons[season].terrain.type != TerrainType::kFlat;
}

/// `felt` in seasons that hang on the place; nothing: as if at the start.
std::vector<NamedEnvironment> EnvironmentsFeeling(const Genotype& genotype,
                                                  const Scenario& scenario,
                                                  std::optional<double> felt) {
  std::vector<NamedEnvironment> environments;
  const Senses none;
  SeasonDeveloper seasons(genotype, scenario, none);
  for (std::size_t i = 0; !seasons.is_over(); ++i) {
    const Season& season = seasons.season();
    std::string name = season.name;
    std::optional<double> inclination;
    if (seasons.AsksImu()) {
      const bool is_free = felt && HangsOnPlace(scenario, i);
      inclination = is_free ? *felt : FeltAtStart(scenario, season);
      if (is_free) name += *felt > 0 ? ", inclined" : ", level";
    }
    const SeasonResult developed = seasons.Next(0, inclination).result;
    environments.push_back(
        {std::move(name), EnvironmentOf(developed.sensed, genotype.states)});
  }
  return environments;
}

}  // namespace

std::vector<NamedEnvironment> SeasonEnvironments(const Genotype& genotype,
                                                 const Scenario& scenario) {
  return EnvironmentsFeeling(genotype, scenario, std::nullopt);
}

std::vector<NamedEnvironment> PossibleEnvironments(const Genotype& genotype,
                                                   const Scenario& scenario) {
  std::vector<NamedEnvironment> possible =
      EnvironmentsFeeling(genotype, scenario, 0);
  // Steeper than any threshold.
  const auto inclined =
      EnvironmentsFeeling(genotype, scenario, std::numbers::pi);
  for (std::size_t i = 0; i < inclined.size(); ++i)
    if (inclined[i].name != possible[i].name) possible.push_back(inclined[i]);
  return possible;
}

}  // namespace plsc
