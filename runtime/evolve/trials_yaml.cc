#include "runtime/evolve/trials_yaml.h"

#include <fmt/format.h>

#include <numbers>
#include <vector>

#include "grammar/number.h"
#include "runtime/text/yaml_reader.h"

namespace plsc {

namespace {

// Beyond it a number is a slip of the pen.
constexpr int kMaxTrials = 1000;

struct NoiseKey {
  const char* name;
  double LifeNoise::*field;
  Quantity quantity;
};

constexpr double kPi = std::numbers::pi;

const std::vector<NoiseKey>& NoiseKeys() {
  using enum Dimension;
  static const std::vector<NoiseKey> keys = {
      // Examples that are shown are amplitudes that make sense.
      {"start_height", &LifeNoise::start_height, {kLength, 0, 1, false, 3e-5}},
      {"place", &LifeNoise::place, {kLength, 0, 10, false, 0.1}},
      {"yaw", &LifeNoise::yaw, {kAngle, 0, kPi, false, kPi / 36}},
      {"inclination",
       &LifeNoise::inclination,
       {kAngle, 0, kPi, false, kPi / 180}},
      // At 0.5 nothing is left of what it touches.
      {"touch", &LifeNoise::touch, {kNumber, 0, 0.5, false, 0.05}},
      {"motor", &LifeNoise::motor, {kAngle, 0, kPi, false, kPi / 90}},
      {"friction", &LifeNoise::friction, {kNumber, 0, 0.9, false, 0.1}},
  };
  return keys;
}

LifeNoise ReadNoise(const YamlValue& value) {
  LifeNoise noise;
  std::optional<YamlMap> map = value.Map("noise, as in {start_height: 30 um}");
  if (!map) return noise;
  for (const NoiseKey& key : NoiseKeys())
    noise.*key.field = map->Number(key.name, 0, key.quantity);
  map->Close();
  return noise;
}

enum class Over : std::uint8_t { kMean, kMedian, kMin };
constexpr EnumNames<Over, 3> kOverNames{
    {{Over::kMean, "mean"}, {Over::kMedian, "median"}, {Over::kMin, "min"}}};

std::optional<double> ReadFitness(const YamlValue& value) {
  if (value.is_map()) {
    YamlMap map = *value.Map("a quantile");
    const auto quantile = map.Find("quantile");
    const std::size_t errors = map.place().error_count();
    map.Close();
    const Quantity share = {Dimension::kNumber, 0, 1, false, 0.25};
    if (quantile) return quantile->Number(share).value_or(0);
    if (map.place().error_count() == errors)
      value.Report(Code::kMissingKey, "expected the key 'quantile' here",
                   "write {quantile: 0.25}, or mean, median or min");
    return std::nullopt;
  }
  switch (value.Choice(kOverNames).value_or(Over::kMean)) {
    case Over::kMean:
      return std::nullopt;
    case Over::kMedian:
      return 0.5;
    case Over::kMin:
      return 0;
  }
  return std::nullopt;
}

std::string PrintFitness(const std::optional<double>& quantile) {
  if (!quantile) return "mean";
  if (*quantile == 0.5) return "median";
  if (*quantile == 0) return "min";
  return fmt::format("{{quantile: {}}}", PrintPlainNumber(*quantile));
}

}  // namespace

TrialOptions ReadTrials(YamlMap& map) {
  TrialOptions options;
  const std::size_t errors = map.place().error_count();
  const auto count = map.Find("trials");
  if (count)
    options.count = static_cast<int>(
        count->Integer(1, kMaxTrials, options.count).value_or(options.count));
  if (const auto fitness = map.Find("trials_fitness"))
    options.quantile = ReadFitness(*fitness);
  options.own_lives = map.Bool("own_lives", options.own_lives);
  if (const auto noise = map.Find("noise")) options.noise = ReadNoise(*noise);
  if (map.place().error_count() == errors && options.count > 1 &&
      options.noise == LifeNoise{})
    count->Report(Code::kMisfit,
                  fmt::format("without noise all {} trials of a robot are the "
                              "same life",
                              options.count),
                  "say what differs, as in 'noise: {start_height: 30 um}', or "
                  "leave out 'trials'");
  return options;
}

std::string PrintTrials(const TrialOptions& options) {
  std::string text;
  text += fmt::format("trials: {}\n", options.count);
  text += fmt::format("trials_fitness: {}\n", PrintFitness(options.quantile));
  text += fmt::format("own_lives: {}\n", options.own_lives ? "True" : "False");
  std::vector<std::string> noise;
  for (const NoiseKey& key : NoiseKeys())
    noise.push_back(fmt::format(
        "{}: {}", key.name,
        PrintQuantity(options.noise.*key.field, key.quantity.dimension)));
  return text + fmt::format("noise: {{{}}}\n", fmt::join(noise, ", "));
}

std::string DescribeTrials(const TrialOptions& options) {
  std::vector<std::string> parts;
  if (options.count > 1)
    parts.push_back(fmt::format("{} trials a robot (fitness: {})",
                                options.count, PrintFitness(options.quantile)));
  if (options.own_lives) parts.emplace_back("own lives");
  std::vector<std::string> noise;
  for (const NoiseKey& key : NoiseKeys())
    if (options.noise.*key.field > 0)
      noise.push_back(fmt::format(
          "{} {}", key.name,
          PrintQuantity(options.noise.*key.field, key.quantity.dimension)));
  if (!noise.empty())
    parts.push_back(fmt::format("noise: {}", fmt::join(noise, ", ")));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace plsc
