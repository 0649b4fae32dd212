// The sources of sim/maths as one, and their hash: for files that compile them
// with other options and another name of the namespace.

#include "sim/maths/arc.cc"
#include "sim/maths/exponential.cc"
#include "sim/maths/hypot.cc"
#include "sim/maths/sine.cc"
#include "tests/sim/maths/maths_hash.h"

namespace plsc {

std::uint64_t HashOfMaths();

std::uint64_t HashOfMaths() {
  return test::MathsHash();
}

}  // namespace plsc
