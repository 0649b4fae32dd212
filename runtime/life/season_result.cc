// The fitness of a season as the authors' program has it (fitness.py:65-81;
// paper, "Fitness function"), in m/s. -0.1 is far below what any robot loses by
// sliding, so that those that cannot move, or do not, come last; going
// backwards counts a tenth.

#include "runtime/life/season_result.h"

#include <fmt/format.h>

#include <algorithm>

#include "grammar/number.h"
#include "runtime/text/quantity.h"

namespace plsc {

namespace {

// What a robot that cannot move, or does not, is worth, m/s: less than the
// fastest slide down a slope (in m/s, as the authors compute it,
// although the paper's Speed is in cm/s).
constexpr double kMotionless = -0.1;
// Sliding back counts a tenth, so that small losses do not end a lineage.
constexpr double kBackwardShare = 0.1;

}  // namespace

double SeasonFitness(double speed, int hinge_count) {
  if (hinge_count == 0 || speed == 0) return kMotionless;
  return speed > 0 ? speed : speed * kBackwardShare;
}

bool IsSpeed(const std::optional<double>& fitness) {
  return fitness && *fitness != kMotionless;
}

std::string FitnessText(const std::optional<double>& fitness, bool is_own) {
  if (!fitness) return "none";
  if (is_own) return PrintRoundedNumber(*fitness, 4);
  return IsSpeed(fitness) ? fmt::format("{:.2f}", kCentimetres * *fitness)
                          : "penalty";
}

std::string FitnessesText(const std::vector<std::optional<double>>& fitnesses,
                          bool is_own) {
  std::vector<std::string> texts;
  texts.reserve(fitnesses.size() + 1);
  for (const std::optional<double>& fitness : fitnesses)
    texts.push_back(FitnessText(fitness, is_own));
  if (!is_own && std::any_of(fitnesses.begin(), fitnesses.end(), IsSpeed))
    texts.emplace_back("cm/s");
  return fmt::format("{}", fmt::join(texts, " "));
}

}  // namespace plsc
