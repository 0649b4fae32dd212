#include "runtime/evolve/evaluation_frame.h"

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace plsc {

namespace {

// Everything of a SeasonResult but its name, copied as it lies in memory: a
// forked process has the same layout. New descriptors travel with the rest.
struct SeasonBytes {
  Outcome outcome;
  bool has_fitness;
  double fitness;
  BodyDescriptors body;
  BrainDescriptors brain;
  Behaviour behaviour;
  std::uint64_t state_hash;
};
static_assert(std::is_trivially_copyable_v<SeasonBytes>);

template <typename T>
void Append(const T& value, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

template <typename T>
bool Take(std::string_view& bytes, T& value) {
  if (bytes.size() < sizeof(value)) return false;
  std::memcpy(&value, bytes.data(), sizeof(value));
  bytes.remove_prefix(sizeof(value));
  return true;
}

}  // namespace

std::string Pack(const Evaluation& evaluation) {
  std::string bytes;
  Append(std::uint64_t{evaluation.seasons.size()}, bytes);
  for (const SeasonResult& season : evaluation.seasons) {
    Append(std::uint64_t{season.season.size()}, bytes);
    bytes += season.season;
    const SeasonBytes fixed = {season.outcome,
                               season.fitness.has_value(),
                               season.fitness.value_or(0),
                               season.body,
                               season.brain,
                               season.behaviour,
                               season.state_hash};
    Append(fixed, bytes);
  }
  return bytes;
}

std::optional<Evaluation> Unpack(std::string_view bytes) {
  Evaluation evaluation;
  std::uint64_t seasons = 0;
  if (!Take(bytes, seasons)) return std::nullopt;
  for (std::uint64_t i = 0; i < seasons; ++i) {
    std::uint64_t length = 0;
    if (!Take(bytes, length) || bytes.size() < length) return std::nullopt;
    SeasonResult season;
    season.season = bytes.substr(0, length);
    bytes.remove_prefix(length);
    SeasonBytes fixed{};
    if (!Take(bytes, fixed)) return std::nullopt;
    season.outcome = fixed.outcome;
    if (fixed.has_fitness) season.fitness = fixed.fitness;
    season.body = fixed.body;
    season.brain = fixed.brain;
    season.behaviour = fixed.behaviour;
    season.state_hash = fixed.state_hash;
    evaluation.seasons.push_back(std::move(season));
  }
  if (!bytes.empty()) return std::nullopt;
  return evaluation;
}

}  // namespace plsc
