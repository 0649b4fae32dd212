#include "runtime/cli/commands/robot_text.h"

#include <fmt/format.h>

#include "grammar/shown_line.h"
#include "runtime/develop/develop.h"
#include "runtime/life/season_developer.h"
#include "runtime/pictures/body_text.h"
#include "runtime/text/quantity.h"

namespace plsc::cli {

std::string SeasonLine(const SeasonResult& result) {
  if (!result.behaviour.is_valid)
    return fmt::format("season {}: {}: {}", Escaped(result.season),
                       OutcomeName(result.outcome), Escaped(result.reason));
  return fmt::format("season {}: speed {:.3f} cm/s, balance {:.4f}, {} modules",
                     Escaped(result.season),
                     kCentimetres * result.behaviour.displacement_velocity_hill,
                     result.behaviour.head_balance, result.body.absolute_size);
}

std::string SeasonsText(const Individual& one) {
  if (one.evaluation.seasons.empty()) return "not evaluated yet\n";
  std::string text;
  for (const SeasonResult& season : one.evaluation.seasons) {
    text += SeasonLine(season) + '\n';
    // Nothing was sensed where a life did not reach.
    if (season.sensed.size() == one.genotype.states.size() &&
        season.body.absolute_size > 0)
      text += BodyText(Develop(one.genotype, EnvironmentOf(season.sensed,
                                                           one.genotype.states))
                           ->body);
    text += '\n';
  }
  return text;
}

}  // namespace plsc::cli
