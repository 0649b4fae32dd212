#include "sim/lattice_noise.h"

#include <catch2/catch.hpp>
#include <set>

namespace plsc {
namespace {

TEST_CASE("Lattice numbers are even, and depend on all that names them",
          "[lattice_noise]") {
  double sum = 0;
  std::set<double> all;
  for (int x = -10; x < 10; ++x) {
    for (int y = -10; y < 10; ++y) {
      const double number = LatticeNoise(7, x, y, 0);
      CHECK(number >= 0);
      CHECK(number < 1);
      CHECK(number == LatticeNoise(7, x, y, 0));
      sum += number;
      all.insert({number, LatticeNoise(7, x, y, 1), LatticeNoise(8, x, y, 0)});
    }
  }
  CHECK(all.size() == 1200);
  // 400 even numbers: the mean's deviation is 0.0144.
  CHECK(sum / 400 == Approx(0.5).margin(0.06));
}

}  // namespace
}  // namespace plsc
