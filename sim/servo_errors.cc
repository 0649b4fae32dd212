// A histogram whose bins are the leading bits of the numbers: exponent and five
// bits of the mantissa, so that a bin is found by a shift and is 1/32 of an
// octave wide, 2 to 3 % of its value. It takes no memory as a life goes on, its
// counts do not depend on the order in which errors come, and its middles are
// exact in binary: same bits everywhere. Some nanoseconds an error; to keep all
// of them and to sort would be a megabyte a life.

#include "sim/servo_errors.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace plsc {
namespace {

// Of a double: bits of the mantissa that are left out, the exponent of 1.
constexpr int kShift = 52 - 5;
constexpr std::int64_t kBias = 1023;

// Octaves that have bins, 2^-30 (1e-9) to 2^10 rad/s, and what is beyond in the
// first and the last: no link spins faster and counts as a robot's.
constexpr std::int64_t kParts = 32;
constexpr std::int64_t kFirst = (kBias - 30) * kParts;

}  // namespace

void ServoErrors::Add(double error) {
  const double size = std::abs(error);
  worst_ = std::max(worst_, size);
  const auto leading =
      static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(size) >> kShift);
  const std::int64_t bin = std::clamp<std::int64_t>(
      leading - kFirst + 1, 0, static_cast<std::int64_t>(kBins) - 1);
  ++counts_[static_cast<std::size_t>(bin)];
  ++count_;
}

double ServoErrors::Median() const {
  const std::uint64_t middle = (count_ + 1) / 2;
  std::uint64_t below = 0;
  std::size_t bin = 0;
  while (bin + 1 < kBins && below + counts_[bin] < middle)
    below += counts_[bin++];
  if (bin == 0) return 0;
  const std::uint64_t leading = static_cast<std::uint64_t>(kFirst) + bin - 1;
  return std::bit_cast<double>(leading << kShift | std::uint64_t{1}
                                                       << (kShift - 1));
}

}  // namespace plsc
