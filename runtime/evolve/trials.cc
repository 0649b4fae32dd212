// Draws come from streams that are named by what is lived and not by who lives
// it first: by default by the key that the season would have undisturbed, so
// that equal robots live equal lives, may be looked up, and the order of
// evaluation and the number of workers change nothing. With own lives the name
// is the individual's. What the IMU tells is drawn before anything develops,
// hence from a stream of the genotype.
//
// Every quantity is drawn, in one order, whether it is used or not: whoever
// adds one kind of noise to an experiment keeps the draws of the others.
//
// A trial that is not completed has no fitness, which is worse than any number
// (Dominates), and no mean or quantile is made of some of the trials only: a
// robot that breaks in one of five is not as good as its other four lives. A
// dead worker tells nothing of the robot; it takes the place of the whole
// season, to be lived anew when the run goes on.

#include "runtime/evolve/trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>

#include "runtime/develop/genotype_key.h"
#include "runtime/vary/rng.h"

namespace plsc {

namespace {

Rng StreamOf(std::uint64_t seed, const std::string& name) {
  const Key key = KeyOf(name);
  return Rng({seed, key.high, key.low, Purpose::kDisturb});
}

/// From -most to most; 0 and never -0 if there is none.
double DrawError(double most, Rng& rng) {
  const double share = 2 * rng.Uniform() - 1;
  return most == 0 ? 0 : most * share;
}

Noise DrawNoise(double amplitude, Rng& rng) {
  const std::uint64_t seed = rng.Next();
  return amplitude == 0 ? Noise{} : Noise{amplitude, seed};
}

/// All but the lean.
void Draw(const LifeNoise& noise, Rng& rng, Disturbance& disturbance) {
  disturbance.lift = noise.start_height * rng.Uniform();
  disturbance.shift_x = DrawError(noise.place, rng);
  disturbance.shift_y = DrawError(noise.place, rng);
  disturbance.yaw = DrawError(noise.yaw, rng);
  disturbance.friction = 1 + DrawError(noise.friction, rng);
  disturbance.touch = DrawNoise(noise.touch, rng);
  disturbance.motor = DrawNoise(noise.motor, rng);
}

/// By season; of nothing where no robot develops.
std::vector<Key> KeysOf(const std::vector<LifePiece>& pieces,
                        std::size_t seasons) {
  std::vector<Key> keys(seasons);
  for (const LifePiece& piece : pieces)
    std::copy(piece.keys.begin(), piece.keys.end(),
              keys.begin() + static_cast<std::ptrdiff_t>(piece.first));
  return keys;
}

/// The trials of one individual, drawn one after the other.
class Drawing {
 public:
  Drawing(const TrialPlan& plan, const LifePlanner& planner,
          const Individual& one)
      : plan_(plan),
        planner_(planner),
        one_(one),
        seasons_(planner.scenario().seasons.size()) {
    const bool is_felt = plan.options.noise.inclination > 0;
    if (plan.options.own_lives)
      whose_ = fmt::format("individual {}", one.id);
    else if (is_felt)
      whose_ = Hex(GenotypeKey(one.genotype));
  }

  Disturbances Next() {
    ++trial_;
    const TrialOptions& options = plan_.options;
    Disturbances life(seasons_);
    if (options.noise == LifeNoise{}) return life;
    for (std::size_t i = 0; i < seasons_; ++i)
      if (options.noise.inclination > 0) {
        Rng rng = StreamOf(plan_.seed, fmt::format("felt by {} in {}, trial {}",
                                                   whose_, i, trial_));
        life[i].lean = DrawError(options.noise.inclination, rng);
      }
    if (!options.own_lives && (trial_ == 1 || options.noise.inclination > 0))
      keys_ = KeysOf(planner_.Plan(one_.genotype, one_.heritage.senses, life),
                     seasons_);
    for (std::size_t i = 0; i < seasons_; ++i) {
      const std::string what = options.own_lives
                                   ? fmt::format("{} in {}", whose_, i)
                                   : Hex(keys_[i]);
      Rng rng = StreamOf(plan_.seed,
                         fmt::format("lived by {}, trial {}", what, trial_));
      Draw(options.noise, rng, life[i]);
    }
    return life;
  }

 private:
  const TrialPlan& plan_;
  const LifePlanner& planner_;
  const Individual& one_;
  std::size_t seasons_ = 0;
  std::string whose_;
  std::vector<Key> keys_;  // of the seasons, but for what is drawn here
  int trial_ = 0;
};

/// Type 7 of Hyndman and Fan (1996), the default of R; 0 is the least, 0.5 the
/// median, 1 the largest.
double QuantileOf(std::vector<double> values, double quantile) {
  std::sort(values.begin(), values.end());
  const double place = quantile * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const double share = place - std::floor(place);
  if (share == 0) return values[below];
  return values[below] + share * (values[below + 1] - values[below]);
}

/// Of the first, so that equal values have exactly themselves as their mean:
/// what cannot move is worth a number that is known again (IsSpeed).
double MeanOf(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value - values[0];
  return values[0] + sum / static_cast<double>(values.size());
}

/// What all trials of a season come to; a dead one with what stands behind it.
void Combine(const std::vector<Trial>& trials, const TrialOptions& options,
             SeasonResult& result, SeasonEvidence& evidence) {
  std::vector<std::optional<double>> fitnesses;
  fitnesses.reserve(trials.size());
  for (const Trial& trial : trials) fitnesses.push_back(trial.result.fitness);
  result.fitness = FitnessOver(fitnesses, options.quantile);
  const auto broken =
      std::find_if(trials.begin(), trials.end(), [](const Trial& trial) {
        return trial.result.outcome != Outcome::kCompleted;
      });
  const auto dead =
      std::find_if(trials.begin(), trials.end(), [](const Trial& trial) {
        return trial.result.outcome == Outcome::kWorkerDied;
      });
  if (dead != trials.end()) {
    result = dead->result;
    evidence = dead->evidence;
  } else if (broken != trials.end()) {
    result.outcome = broken->result.outcome;
  }
  if (broken == trials.end() || trials.size() == 1) return;
  const auto& told = dead != trials.end() ? dead : broken;
  result.reason =
      fmt::format("in trial {} of {}: {}", told - trials.begin() + 1,
                  trials.size(), told->result.reason);
}

}  // namespace

std::vector<Disturbances> TrialsOf(const TrialPlan& plan,
                                   const LifePlanner& planner,
                                   const Individual& one) {
  if (!HasTrials(plan.options)) return {one.disturbances};
  assert(one.disturbances.empty() && plan.options.count >= 1);
  std::vector<Disturbances> trials;
  trials.reserve(static_cast<std::size_t>(plan.options.count));
  Drawing drawing(plan, planner, one);
  for (int i = 0; i < plan.options.count; ++i) trials.push_back(drawing.Next());
  return trials;
}

std::optional<double> FitnessOver(
    const std::vector<std::optional<double>>& fitnesses,
    std::optional<double> quantile) {
  assert(!fitnesses.empty());
  std::vector<double> values;
  for (const std::optional<double>& fitness : fitnesses) {
    if (!fitness) return std::nullopt;
    values.push_back(*fitness);
  }
  return quantile ? QuantileOf(std::move(values), *quantile) : MeanOf(values);
}

EvaluatedLife OverTrials(std::vector<EvaluatedLife> trials,
                         const std::vector<Disturbances>& disturbances,
                         const TrialOptions& options) {
  assert(!trials.empty() && trials.size() == disturbances.size());
  if (!HasTrials(options)) return std::move(trials[0]);
  EvaluatedLife life = trials[0];
  for (std::size_t season = 0; season < life.evidence.size(); ++season) {
    std::vector<Trial> told;
    for (std::size_t i = 0; i < trials.size(); ++i)
      told.push_back({DisturbanceIn(disturbances[i], season),
                      std::move(trials[i].evaluation.seasons[season]),
                      std::move(trials[i].evidence[season])});
    Combine(told, options, life.evaluation.seasons[season],
            life.evidence[season]);
    life.evidence[season].trials = std::move(told);
  }
  return life;
}

}  // namespace plsc
