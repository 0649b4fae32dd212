#include "runtime/vary/rng.h"

#include <Random123/philox.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/maths/exponential.h"

namespace plsc {

std::uint64_t Rng::Next() {
  if (used_ == words_.size()) {
    // The second word of the key is free for a use that is not a run's.
    const r123::Philox4x64::ctr_type counter = {
        {block_++, key_.generation, key_.individual,
         static_cast<std::uint64_t>(key_.purpose)}};
    const r123::Philox4x64::key_type key = {{key_.seed, 0}};
    const r123::Philox4x64::ctr_type words = r123::Philox4x64()(counter, key);
    std::copy(words.begin(), words.end(), words_.begin());
    used_ = 0;
  }
  return words_[used_++];
}

double Rng::Uniform() {
  // A double has 53 bits; the upper ones, all of them exact.
  return static_cast<double>(Next() >> 11) * 0x1p-53;
}

double Rng::Uniform(double low, double high) {
  assert(std::isfinite(low) && std::isfinite(high) && low <= high);
  // The sum may round up, and beyond the limit is not a legal argument.
  return std::min(low + (high - low) * Uniform(), high);
}

std::size_t Rng::Index(std::size_t count) {
  assert(count >= 1);
  // Numbers below 2^64 mod count are refused: what is left is a multiple of
  // count, so that no remainder is more likely than another.
  const std::uint64_t refused = (0 - std::uint64_t{count}) % count;
  std::uint64_t bits = Next();
  while (bits < refused) bits = Next();
  return static_cast<std::size_t>(bits % count);
}

double Rng::Normal() {
  // Ratio of uniforms (Kinderman and Monahan 1977): of a point (u, v) uniform
  // in 0 < u <= 1, |v| <= sqrt(2/e), v/u is normal when u <= exp(-x^2/4). The
  // result is one division; the logarithm only decides whether to accept.
  constexpr double kHalfWidth = 0.8577638849607068;  // sqrt(2/e)
  while (true) {
    const double u = 1 - Uniform();  // (0, 1]
    const double v = (2 * Uniform() - 1) * kHalfWidth;
    const double x = v / u;
    if (x * x <= -4 * Log(u)) return x;
  }
}

}  // namespace plsc
