#include "runtime/cli/robots/robot_setting.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "runtime/scenario/scenario_profile.h"

namespace plsc::cli {

namespace {

RobotSetting Usual() {
  return {OptionsFor(ProfileScenario(Profile::kPaper),
                     ProfileSeason(Profile::kPaper, {})),
          {}};
}

/// As Life begins it: who lives on stands on the ground already.
RobotSetting InSeason(const Scenario& scenario, std::size_t index) {
  const Season& season = scenario.seasons[index];
  RobotSetting setting{OptionsFor(scenario, season), season.terrain};
  if (scenario.lives == Lives::kContinuous && index > 0)
    setting.options.start_height.reset();
  return setting;
}

std::optional<std::size_t> SeasonCalled(const Scenario& scenario,
                                        const std::string& name) {
  for (std::size_t i = 0; i < scenario.seasons.size(); ++i)
    if (scenario.seasons[i].name == name) return i;
  return std::nullopt;
}

/// By its name, else by what is sensed in it.
std::optional<std::size_t> SeasonOf(const RobotFound& robot,
                                    const NamedEnvironment& named) {
  const Scenario& scenario = *robot.scenario;
  if (const auto found = SeasonCalled(scenario, named.name)) return found;
  const auto& seasons = robot.loaded.mapped.program.environments;
  const auto same =
      std::find_if(seasons.begin(), seasons.end(), [&](const auto& season) {
        return season.environment == named.environment;
      });
  if (same == seasons.end()) return std::nullopt;
  return SeasonCalled(scenario, same->name);
}

RobotSetting OnFlatGround(const Scenario& scenario,
                          const NamedEnvironment& named, Io& io) {
  RobotSetting setting = InSeason(scenario, 0);
  setting.terrain = {};
  io.err << fmt::format(
      "warning: '{}' is no season: written on flat ground, with the physics of "
      "season '{}'\n",
      named.name, scenario.seasons.front().name);
  return setting;
}

}  // namespace

std::vector<RobotSetting> SettingsOf(const RobotFound& robot, Io& io) {
  std::vector<RobotSetting> settings;
  for (const NamedEnvironment& named : robot.environments) {
    if (!robot.scenario) {
      settings.push_back(Usual());
      continue;
    }
    const auto season = SeasonOf(robot, named);
    settings.push_back(season ? InSeason(*robot.scenario, *season)
                              : OnFlatGround(*robot.scenario, named, io));
  }
  return settings;
}

}  // namespace plsc::cli
