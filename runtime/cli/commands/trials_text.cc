#include "runtime/cli/commands/trials_text.h"

#include <fmt/format.h>

#include <numbers>

#include "grammar/enum_names.h"
#include "grammar/shown_line.h"
#include "runtime/life/season_result.h"
#include "runtime/text/quantity.h"

namespace plsc::cli {

namespace {

/// "lift 12.3 um, friction 93.1 %": only what was disturbed.
std::string HowDisturbed(const Disturbance& one) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  std::string text;
  const auto add = [&](const std::string& part) {
    text += (text.empty() ? "" : ", ") + part;
  };
  if (one.lift != 0) add(fmt::format("lift {:.3g} um", 1e6 * one.lift));
  if (one.shift_x != 0 || one.shift_y != 0)
    add(fmt::format("shift {:.3g} {:.3g} cm", 100 * one.shift_x,
                    100 * one.shift_y));
  if (one.yaw != 0) add(fmt::format("yaw {:.3g} deg", kDegrees * one.yaw));
  if (one.friction != 1)
    add(fmt::format("friction {:.1f} %", 100 * one.friction));
  if (one.lean != 0) add(fmt::format("lean {:.3g} deg", kDegrees * one.lean));
  if (one.touch.amplitude != 0)
    add(fmt::format("touch {:.3g}", one.touch.amplitude));
  if (one.motor.amplitude != 0)
    add(fmt::format("motor {:.3g} deg", kDegrees * one.motor.amplitude));
  return text;
}

std::string TrialLine(std::size_t number, const StoredTrial& trial,
                      bool is_own) {
  const std::string came =
      trial.fitness && !is_own
          ? fmt::format("{:8.3f} cm/s", kCentimetres * *trial.fitness)
          : fmt::format("{:>8}     ", FitnessText(trial.fitness, is_own));
  const std::string disturbed = HowDisturbed(trial.disturbance);
  std::string line = fmt::format("  {:>3} {}  {}", number, came, disturbed);
  if (trial.outcome != Outcome::kCompleted)
    line += fmt::format("{}{} ({})", disturbed.empty() ? "" : "; ",
                        OutcomeName(trial.outcome), Escaped(trial.reason));
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

}  // namespace

std::string TrialsText(const Experiment& experiment,
                       const std::vector<std::vector<StoredTrial>>& trials) {
  std::string text;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    text += fmt::format("\ntrials in {}, by fitness (drawn is the first):\n",
                        Escaped(experiment.scenario.seasons.at(i).name));
    for (std::size_t n = 0; n < trials[i].size(); ++n)
      text += TrialLine(n + 1, trials[i][n],
                        experiment.scenario.seasons.at(i).fitness.has_value());
  }
  return text;
}

}  // namespace plsc::cli
