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

constexpr std::array<Ask, 4> kAsks{{{"check", kCheckKeys, Check},
                                    {"format", kFormatKeys, FormatText},
                                    {"develop", kDevelopKeys, DevelopAll},
                                    {"live", kLiveKeys, LiveAll}}};

}  // namespace

std::span<const Ask> Asks() {
  return kAsks;
}

}  // namespace plsc::service
