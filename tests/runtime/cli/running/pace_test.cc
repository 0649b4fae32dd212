#include "runtime/cli/running/pace.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

using cli::Pace;
using cli::PaceMeter;

Progress Reached(int generation, std::int64_t evaluations,
                 double simulated_seconds = 0) {
  Progress progress;
  progress.generation = generation;
  progress.evaluations = evaluations;
  progress.total = 10'000;
  progress.simulated_seconds = simulated_seconds;
  return progress;
}

TEST_CASE("nothing is known before the first evaluation", "[pace]") {
  const PaceMeter meter;
  CHECK_FALSE(meter.At(3).evaluations_per_second);
  CHECK_FALSE(meter.At(3).times_real);
  CHECK_FALSE(meter.At(3).seconds_left);
  CHECK_FALSE(meter.At(3).looked_up_share);
}

TEST_CASE("rates count from the beginning of the session at first", "[pace]") {
  PaceMeter meter(500);
  meter.Add(5, Reached(5, 510, 1000));
  meter.Add(10, Reached(5, 540, 2000));
  const Pace pace = meter.At(20);
  CHECK(*pace.evaluations_per_second == Approx(2));
  CHECK(*pace.times_real == Approx(100));
  CHECK(*pace.seconds_left == Approx((10'000 - 540) / 2.0));
}

TEST_CASE("rates are those of the last minute", "[pace]") {
  PaceMeter meter;
  // Ten evaluations a second for long, a generation every 10 s; then five.
  int generation = 0;
  std::int64_t evaluations = 0;
  double seconds = 0;
  for (; seconds < 300; seconds += 1) {
    generation = static_cast<int>(seconds) / 10;
    meter.Add(seconds, Reached(generation, evaluations += 10));
  }
  CHECK(*meter.At(seconds).evaluations_per_second == Approx(10).epsilon(0.05));
  for (; seconds < 361; seconds += 1) {
    generation = static_cast<int>(seconds) / 10;
    meter.Add(seconds, Reached(generation, evaluations += 5));
  }
  CHECK(*meter.At(seconds).evaluations_per_second == Approx(5).epsilon(0.05));
}

TEST_CASE("of long generations all of the one before counts", "[pace]") {
  PaceMeter meter;
  // 1000 s each, of which the first evaluations take no time.
  for (int generation = 0; generation < 5; ++generation) {
    meter.Add(1000 * generation + 1,
              Reached(generation, 100 * generation + 50));
    for (int i = 1; i <= 50; ++i)
      meter.Add(1000 * generation + 19 * i,
                Reached(generation, 100 * generation + 50 + i));
  }
  meter.Add(5001, Reached(5, 550));
  // 100 evaluations since the generation before began, 1000 s ago, rather than
  // 75 in the last minute.
  CHECK(*meter.At(5001).evaluations_per_second == Approx(0.1));
}

TEST_CASE("when nothing happens the rate falls", "[pace]") {
  PaceMeter meter;
  meter.Add(10, Reached(0, 100));
  CHECK(*meter.At(10).evaluations_per_second == Approx(10));
  CHECK(*meter.At(100).evaluations_per_second == Approx(1));
}

TEST_CASE("what was looked up is a share of all seasons", "[pace]") {
  PaceMeter meter;
  Progress progress = Reached(0, 10);
  progress.simulations = 15;
  progress.looked_up = 5;
  meter.Add(1, progress);
  CHECK(*meter.At(1).looked_up_share == Approx(0.25));
}

TEST_CASE("all found in a cache is a rate without a simulation", "[pace]") {
  PaceMeter meter;
  meter.Add(1, Reached(0, 100));
  CHECK(*meter.At(1).times_real == 0);
  CHECK(*meter.At(1).seconds_left == Approx(99));
}

}  // namespace
}  // namespace plsc
