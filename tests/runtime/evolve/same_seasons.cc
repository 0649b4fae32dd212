#include "tests/runtime/evolve/same_seasons.h"

#include <fmt/format.h>

#include <algorithm>

namespace plsc::test {

namespace {

/// All continuations of `begun` to `seasons` seasons: each next one is of a
/// part that is there, or of a new one.
void Continue(std::vector<int> begun, std::size_t seasons,
              std::vector<std::vector<int>>& patterns) {
  if (begun.size() == seasons) {
    patterns.push_back(std::move(begun));
    return;
  }
  const int parts =
      begun.empty() ? 0 : *std::max_element(begun.begin(), begun.end()) + 1;
  for (int part = 0; part <= parts; ++part) {
    begun.push_back(part);
    Continue(begun, seasons, patterns);
    begun.pop_back();
  }
}

}  // namespace

std::vector<std::vector<int>> SeasonPatterns(int seasons) {
  std::vector<std::vector<int>> patterns;
  for (int count = 1; count <= seasons; ++count)
    Continue({}, static_cast<std::size_t>(count), patterns);
  return patterns;
}

Scenario PatternScenario(const std::vector<int>& pattern) {
  Scenario scenario;
  scenario.sample_interval = 0.01;
  scenario.imu.settling = 0.05;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    Season season;
    season.name = fmt::format("s{}", i);
    season.duration = 0.04;
    if (pattern[i] > 0) {
      season.terrain.type = TerrainType::kTilted;
      season.terrain.tilt = 0.1 * pattern[i];
    }
    season.senses["hot"] = i % 2 == 0 ? "False" : "True";
    scenario.seasons.push_back(season);
  }
  return scenario;
}

std::vector<Scenario> PatternVariants(const std::vector<int>& pattern) {
  std::vector<Scenario> variants;
  for (const Lives lives : {Lives::kIndependent, Lives::kContinuous})
    for (const Plasticity plasticity :
         {Plasticity::kLifelong, Plasticity::kMorphogenesis})
      for (const Sensing sensing : {Sensing::kImu, Sensing::kGiven}) {
        Scenario scenario = PatternScenario(pattern);
        scenario.lives = lives;
        scenario.plasticity = plasticity;
        scenario.sensing = sensing;
        if (sensing == Sensing::kGiven)
          for (std::size_t i = 0; i < pattern.size(); ++i)
            scenario.seasons[i].senses["inclined"] =
                pattern[i] > 0 ? "True" : "False";
        variants.push_back(std::move(scenario));
      }
  return variants;
}

}  // namespace plsc::test
