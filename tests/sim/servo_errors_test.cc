#include "sim/servo_errors.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

namespace plsc {
namespace {

TEST_CASE("Without errors there is no error", "[servo_errors]") {
  ServoErrors errors;
  CHECK(errors.Median() == 0);
  CHECK(errors.worst() == 0);
  errors.Add(0);
  CHECK(errors.Median() == 0);
}

TEST_CASE("The median is that of sorted sizes, to the width of a bin",
          "[servo_errors]") {
  std::mt19937 random(17);
  for (const int count : {1, 2, 3, 10, 1001}) {
    ServoErrors errors;
    std::vector<double> sizes;
    for (int i = 0; i < count; ++i) {
      const double part = static_cast<double>(random()) / 4294967296.0;
      const double error = std::pow(10, 9 * part - 7);
      errors.Add(i % 2 == 0 ? error : -error);
      sizes.push_back(error);
    }
    std::sort(sizes.begin(), sizes.end());
    const auto middle = static_cast<std::size_t>((count - 1) / 2);
    CAPTURE(count, sizes[middle]);
    CHECK(errors.Median() == Approx(sizes[middle]).epsilon(0.0157));
    CHECK(errors.worst() == sizes.back());
  }
}

TEST_CASE("What is beyond all bins is in the first or the last",
          "[servo_errors]") {
  ServoErrors errors;
  for (int i = 0; i < 3; ++i) errors.Add(1e-10);
  CHECK(errors.Median() == 0);
  for (int i = 0; i < 4; ++i) errors.Add(-1e9);
  CHECK(errors.Median() == Approx(1024).epsilon(0.02));
  CHECK(errors.worst() == 1e9);
}

}  // namespace
}  // namespace plsc
