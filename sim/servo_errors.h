#pragma once

// By how much joints turn otherwise than their servos are told, of all steps
// and joints of a life. A servo within its torque turns its joint exactly as it
// is told, so the median tells how well the equations of motion were solved:
// it is near 0 where they were, whatever the few do that are held up.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "sim/maths/bits.h"

namespace plsc {

class ServoErrors {
 public:
  /// rad/s, of one joint in one step; the sign does not matter.
  void Add(double error) {
    const double size = std::abs(error);
    worst_ = std::max(worst_, size);
    const auto leading =
        static_cast<std::int64_t>(BitCast<std::uint64_t>(size) >> kShift);
    const std::int64_t bin =
        std::clamp<std::int64_t>(leading - kFirst + 1, 0, kBins - 1);
    ++counts_[static_cast<std::size_t>(bin)];
  }

  /// rad/s, within 1.6 %; 0 if it is below 1e-9, or if there were none.
  double Median() const;
  double worst() const { return worst_; }  ///< rad/s, exact

 private:
  // Of a double: bits of the mantissa that are left out.
  static constexpr int kShift = 52 - 5;
  // Octaves that have bins, 2^-30 (1e-9) to 2^10 rad/s, and what is beyond in
  // the first and the last: no link spins faster and counts as a robot's.
  static constexpr std::int64_t kParts = 32;
  static constexpr std::int64_t kFirst = (1023 - 30) * kParts;
  static constexpr std::int64_t kBins = 1 + 40 * kParts;

  std::array<std::uint32_t, kBins> counts_{};
  double worst_ = 0;
};

}  // namespace plsc
