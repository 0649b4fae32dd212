// Every number as eight bytes, spelled out field by field: a struct's own bytes
// have padding, and caches outlive the compiler that laid it out. kLayout must
// change with Simulated or Behaviour, or what an older program wrote would be
// read as something else. Reading trusts nothing, as a frame may come from a
// damaged cache.

#include "runtime/evolve/simulated_frame.h"

#include <bit>
#include <cstdint>

namespace plsc {

namespace {

// Of this layout; a change of Simulated or Behaviour makes another.
constexpr std::uint64_t kLayout = 3;

// Everything is words of 8 bytes, the lowest first; texts follow their length.
class Packer {
 public:
  void Add(std::uint64_t word) {
    for (int i = 0; i < 8; ++i)
      bytes_ += static_cast<char>((word >> (8 * i)) & 0xff);
  }
  void Add(double value) { Add(std::bit_cast<std::uint64_t>(value)); }
  void Add(const std::string& text) {
    Add(std::uint64_t{text.size()});
    bytes_ += text;
  }
  std::string Take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : rest_(bytes) {}

  std::uint64_t Word() {
    if (rest_.size() < 8) {
      is_whole_ = false;
      return 0;
    }
    std::uint64_t word = 0;
    for (int i = 0; i < 8; ++i)
      word |= std::uint64_t{static_cast<unsigned char>(
                  rest_[static_cast<std::size_t>(i)])}
              << (8 * i);
    rest_.remove_prefix(8);
    return word;
  }
  double Number() { return std::bit_cast<double>(Word()); }
  std::string Text() {
    const std::uint64_t length = Word();
    if (rest_.size() < length) {
      is_whole_ = false;
      return "";
    }
    std::string text(rest_.substr(0, length));
    rest_.remove_prefix(length);
    return text;
  }
  bool is_whole() const { return is_whole_; }
  bool is_at_end() const { return is_whole_ && rest_.empty(); }

 private:
  std::string_view rest_;
  bool is_whole_ = true;
};

void AddSeason(const Simulated& season, Packer& packer) {
  packer.Add(season.begin);
  packer.Add(std::uint64_t{season.inclination.has_value()});
  packer.Add(season.inclination.value_or(0));
  packer.Add(static_cast<std::uint64_t>(season.outcome));
  packer.Add(season.reason);
  const Behaviour& behaviour = season.behaviour;
  packer.Add(std::uint64_t{behaviour.is_valid});
  packer.Add(behaviour.displacement_velocity_hill);
  packer.Add(behaviour.displacement_velocity);
  packer.Add(behaviour.velocity);
  packer.Add(behaviour.head_balance);
  packer.Add(behaviour.contacts);
  packer.Add(behaviour.servo_error_median);
  packer.Add(behaviour.servo_error_worst);
  packer.Add(behaviour.core_turns);
  packer.Add(behaviour.final_x);
  packer.Add(behaviour.final_y);
  packer.Add(behaviour.final_z);
  packer.Add(behaviour.heading);
  packer.Add(behaviour.straightness);
  packer.Add(behaviour.turning);
  packer.Add(behaviour.energy);
  packer.Add(behaviour.cost_of_transport);
  packer.Add(behaviour.target_distance);
  packer.Add(season.state_hash);
  packer.Add(static_cast<std::uint64_t>(season.steps));
  packer.Add(static_cast<std::uint64_t>(season.solver_warnings));
}

Simulated TakeSeason(Unpacker& bytes) {
  Simulated season;
  season.begin = bytes.Number();
  const bool has_inclination = bytes.Word() != 0;
  const double inclination = bytes.Number();
  if (has_inclination) season.inclination = inclination;
  season.outcome = static_cast<Outcome>(bytes.Word());
  season.reason = bytes.Text();
  Behaviour& behaviour = season.behaviour;
  behaviour.is_valid = bytes.Word() != 0;
  behaviour.displacement_velocity_hill = bytes.Number();
  behaviour.displacement_velocity = bytes.Number();
  behaviour.velocity = bytes.Number();
  behaviour.head_balance = bytes.Number();
  behaviour.contacts = bytes.Number();
  behaviour.servo_error_median = bytes.Number();
  behaviour.servo_error_worst = bytes.Number();
  behaviour.core_turns = bytes.Number();
  behaviour.final_x = bytes.Number();
  behaviour.final_y = bytes.Number();
  behaviour.final_z = bytes.Number();
  behaviour.heading = bytes.Number();
  behaviour.straightness = bytes.Number();
  behaviour.turning = bytes.Number();
  behaviour.energy = bytes.Number();
  behaviour.cost_of_transport = bytes.Number();
  behaviour.target_distance = bytes.Number();
  season.state_hash = bytes.Word();
  season.steps = static_cast<std::int64_t>(bytes.Word());
  season.solver_warnings = static_cast<int>(bytes.Word());
  return season;
}

}  // namespace

std::string PackSimulated(const std::vector<Simulated>& seasons) {
  Packer packer;
  packer.Add(kLayout);
  packer.Add(std::uint64_t{seasons.size()});
  for (const Simulated& season : seasons) AddSeason(season, packer);
  return packer.Take();
}

std::optional<std::vector<Simulated>> UnpackSimulated(std::string_view bytes) {
  Unpacker unpacker(bytes);
  if (unpacker.Word() != kLayout) return std::nullopt;
  const std::uint64_t count = unpacker.Word();
  std::vector<Simulated> seasons;
  for (std::uint64_t i = 0; i < count && unpacker.is_whole(); ++i) {
    seasons.push_back(TakeSeason(unpacker));
    if (seasons.back().outcome > Outcome::kStopped) return std::nullopt;
  }
  if (!unpacker.is_at_end()) return std::nullopt;
  return seasons;
}

}  // namespace plsc
