#pragma once

// All bits of all functions of sim/maths over many arguments, as one number.

#include <cstdint>

#include "sim/fnv.h"
#include "sim/maths/arc.h"
#include "sim/maths/exponential.h"
#include "sim/maths/hypot.h"
#include "sim/maths/sine.h"
#include "tests/sim/maths/ulps.h"

namespace plsc::test {

/// On file: whoever changes it changes every life (CHANGELOG.md, RESULTS).
inline constexpr std::uint64_t kMathsHash = 0x61b85f1ab51bb97f;

inline std::uint64_t MathsHash() {
  Fnv hash;
  Arguments arguments(16);
  for (int i = 0; i < 20'000; ++i) {
    const double small = arguments.Between(-1, 1);
    const double other = arguments.Between(-1, 1);
    const double any = arguments.OfExponent(-1022, 1023);
    // Near what are the ends of intervals.
    const double near = (static_cast<double>(arguments.Bits() % 64) - 32) *
                            0x1.921fb54442d18p-3 +
                        arguments.OfExponent(-60, -20);
    for (const double x : {small, 4 * other, 1000 * small, any, near}) {
      const SineCosine both = SinCos(x);
      for (const double y :
           {Sin(x), Cos(x), both.sine, both.cosine, Exp(x), Log(x < 0 ? -x : x),
            Atan2(x, other), Atan2(any, x), Acos(x > 1 || x < -1 ? 1 / x : x),
            Hypot(x, other), Hypot(any, x)})
        hash.Add(y);
    }
  }
  return hash.value();
}

}  // namespace plsc::test
