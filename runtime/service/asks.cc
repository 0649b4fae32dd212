#include "runtime/service/asks.h"

#include <array>

namespace plsc::service {

namespace {

using Key = std::string_view;

constexpr std::array<Key, 3> kCheckKeys{"text", "name", "lint"};
constexpr std::array<Key, 2> kFormatKeys{"text", "name"};
constexpr std::array<Key, 5> kDevelopKeys{"text", "name", "genotype",
                                          "environment", "scenario"};
constexpr std::array<Key, 6> kLiveKeys{"text",     "name",   "genotype",
                                       "scenario", "engine", "record"};

constexpr std::array<Key, 3> kCompareKeys{"before", "text", "name"};
constexpr std::array<Key, 3> kParameterKeys{"text", "name", "at"};
constexpr std::array<Key, 3> kScenarioKeys{"scenario", "engine", "set"};

constexpr std::array<Ask, 9> kAsks{{{"check", kCheckKeys, Check},
                                    {"format", kFormatKeys, FormatText},
                                    {"develop", kDevelopKeys, DevelopAll},
                                    {"explain", kDevelopKeys, Explain},
                                    {"live", kLiveKeys, LiveAll},
                                    {"picture", kDevelopKeys, Draw},
                                    {"compare", kCompareKeys, Compare},
                                    {"parameters", kParameterKeys, Parameters},
                                    {"scenario", kScenarioKeys, ShowScenario}}};

}  // namespace

std::span<const Ask> Asks() {
  return kAsks;
}

}  // namespace plsc::service
