#include "sim/schedule.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("Samples are due at the nearest steps, the end included",
          "[schedule]") {
  struct Row {
    const char* why;
    double duration, interval, step;
    std::vector<std::int64_t> steps;
  };
  const Row rows[] = {
      {"whole intervals", 0.6, 0.2, 0.005, {0, 40, 80, 120}},
      {"the end is no multiple", 0.5, 0.2, 0.005, {0, 40, 80, 100}},
      {"no step fits the interval", 0.4, 0.2, 0.003, {0, 67, 133}},
      {"the duration is rounded", 0.0124, 0.005, 0.005, {0, 1, 2}},
      {"a sample a step at most", 0.015, 0.001, 0.005, {0, 1, 2, 3}},
      {"no life at all", 0, 0.2, 0.005, {0}},
      {"shorter than an interval", 0.1, 0.2, 0.005, {0, 20}},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    SimulationOptions options;
    options.duration = row.duration;
    options.sample_interval = row.interval;
    options.physics.step = row.step;
    CHECK(SampleSteps(options) == row.steps);
  }
}

TEST_CASE("Nothing drifts over a long life", "[schedule]") {
  SimulationOptions options;
  options.duration = 1000;
  const auto steps = SampleSteps(options);
  REQUIRE(steps.size() == 5001);
  CHECK(steps[5000] == 200000);
  CHECK(steps[3333] == 133320);
  // 8 Hz against 5 ms: each 25 steps, for ever.
  for (int update = 0; update < 8000; ++update)
    REQUIRE(NearestStep(update / 8.0, 0.005) == 25 * update);
}

}  // namespace
}  // namespace plsc
