#include "runtime/evolve/evaluation_frame.h"

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace plsc {

namespace {

// Everything of a SeasonResult but its texts, copied as it lies in memory: a
// forked process has the same layout. New descriptors travel with the rest.
struct SeasonBytes {
  Outcome outcome;
  bool has_fitness;
  double fitness;
  BodyDescriptors body;
  BrainDescriptors brain;
  Behaviour behaviour;
  std::uint64_t state_hash;
  double begin;
  bool has_inclination;
  double inclination;
  Change change;
  Profile profile;
  std::int64_t steps;
  int solver_warnings;
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

void AppendText(const std::string& text, std::string& bytes) {
  Append(std::uint64_t{text.size()}, bytes);
  bytes += text;
}

bool TakeText(std::string_view& bytes, std::string& text) {
  std::uint64_t length = 0;
  if (!Take(bytes, length) || bytes.size() < length) return false;
  text = bytes.substr(0, length);
  bytes.remove_prefix(length);
  return true;
}

void AppendTexts(const SeasonResult& season, std::string& bytes) {
  AppendText(season.season, bytes);
  AppendText(season.reason, bytes);
  AppendText(season.change_reason, bytes);
  Append(std::uint64_t{season.sensed.size()}, bytes);
  for (const SensedState& state : season.sensed) {
    AppendText(state.name, bytes);
    AppendText(state.value, bytes);
    Append(state.is_felt, bytes);
  }
}

bool TakeTexts(std::string_view& bytes, SeasonResult& season) {
  std::uint64_t states = 0;
  if (!TakeText(bytes, season.season) || !TakeText(bytes, season.reason) ||
      !TakeText(bytes, season.change_reason) || !Take(bytes, states))
    return false;
  for (std::uint64_t i = 0; i < states; ++i) {
    SensedState state;
    if (!TakeText(bytes, state.name) || !TakeText(bytes, state.value) ||
        !Take(bytes, state.is_felt))
      return false;
    season.sensed.push_back(std::move(state));
  }
  return true;
}

SeasonBytes BytesOf(const SeasonResult& season) {
  // All bits are sent, those between the fields too: none may be unset.
  SeasonBytes fixed;
  std::memset(static_cast<void*>(&fixed), 0, sizeof fixed);
  fixed.outcome = season.outcome;
  fixed.has_fitness = season.fitness.has_value();
  fixed.fitness = season.fitness.value_or(0);
  fixed.body = season.body;
  fixed.brain = season.brain;
  fixed.behaviour = season.behaviour;
  fixed.state_hash = season.state_hash;
  fixed.begin = season.begin;
  fixed.has_inclination = season.inclination.has_value();
  fixed.inclination = season.inclination.value_or(0);
  fixed.change = season.change;
  fixed.profile = season.profile;
  fixed.steps = season.steps;
  fixed.solver_warnings = season.solver_warnings;
  return fixed;
}

void Fill(const SeasonBytes& fixed, SeasonResult& season) {
  season.outcome = fixed.outcome;
  if (fixed.has_fitness) season.fitness = fixed.fitness;
  season.body = fixed.body;
  season.brain = fixed.brain;
  season.behaviour = fixed.behaviour;
  season.state_hash = fixed.state_hash;
  season.begin = fixed.begin;
  if (fixed.has_inclination) season.inclination = fixed.inclination;
  season.change = fixed.change;
  season.profile = fixed.profile;
  season.steps = fixed.steps;
  season.solver_warnings = fixed.solver_warnings;
}

}  // namespace

std::string Pack(const Evaluation& evaluation) {
  std::string bytes;
  Append(std::uint64_t{evaluation.seasons.size()}, bytes);
  for (const SeasonResult& season : evaluation.seasons) {
    AppendTexts(season, bytes);
    Append(BytesOf(season), bytes);
  }
  return bytes;
}

std::optional<Evaluation> Unpack(std::string_view bytes) {
  Evaluation evaluation;
  std::uint64_t seasons = 0;
  if (!Take(bytes, seasons)) return std::nullopt;
  for (std::uint64_t i = 0; i < seasons; ++i) {
    SeasonResult season;
    SeasonBytes fixed{};
    if (!TakeTexts(bytes, season) || !Take(bytes, fixed)) return std::nullopt;
    Fill(fixed, season);
    evaluation.seasons.push_back(std::move(season));
  }
  if (!bytes.empty()) return std::nullopt;
  return evaluation;
}

}  // namespace plsc
