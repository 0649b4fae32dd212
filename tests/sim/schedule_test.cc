#include "sim/schedule.h"

#include <catch2/catch.hpp>
#include <utility>
#include <vector>

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

/// Steps before which updates are due, with their times.
std::vector<std::pair<std::int64_t, double>> Updates(Refresh refresh,
                                                     double rate, double step,
                                                     std::int64_t steps) {
  ServoOptions servo;
  servo.refresh = refresh;
  servo.update_rate = rate;
  RefreshSchedule schedule(servo, step);
  std::vector<std::pair<std::int64_t, double>> updates;
  for (std::int64_t i = 0; i < steps; ++i)
    if (const auto due = schedule.Due(i)) updates.emplace_back(i, *due);
  return updates;
}

TEST_CASE("Exact updates are nearest to their times, from birth on",
          "[schedule]") {
  using Pairs = std::vector<std::pair<std::int64_t, double>>;
  CHECK(Updates(Refresh::kExact, 8, 0.005, 60) ==
        Pairs{{0, 0}, {25, 0.125}, {50, 0.25}});
  CHECK(Updates(Refresh::kExact, 8, 0.003, 100) ==
        Pairs{{0, 0}, {42, 0.125}, {83, 0.25}});
  // Quicker than the steps: one a step, at the first time that is due.
  CHECK(Updates(Refresh::kExact, 400, 0.005, 3).size() == 3);
}

TEST_CASE("Late updates are strictly later than their period", "[schedule]") {
  // As the authors' program: 0.130 s at 5 ms and 0.126 s at 3 ms.
  struct Row {
    double step, period;
  };
  for (const Row& row : {Row{0.005, 0.130}, Row{0.003, 0.126}}) {
    const auto updates = Updates(Refresh::kLate, 8, row.step, 1000);
    REQUIRE(updates.size() > 20);
    for (std::size_t i = 0; i < updates.size(); ++i) {
      const double time = row.period * static_cast<double>(i + 1);
      CHECK(updates[i].second == Approx(time).epsilon(1e-12));
      CHECK(static_cast<double>(updates[i].first) * row.step ==
            Approx(time).epsilon(1e-12));
    }
  }
}

TEST_CASE("Servos that are slower than any life get the first target only",
          "[schedule]") {
  for (const double rate : {1e-3, 1e-9, 1e-17, 1e-18, 1e-100, 1e-308, 5e-324}) {
    CAPTURE(rate);
    CHECK(Updates(Refresh::kExact, rate, 0.005, 2000) ==
          std::vector<std::pair<std::int64_t, double>>{{0, 0}});
    CHECK(Updates(Refresh::kLate, rate, 0.005, 2000).empty());
  }
}

TEST_CASE("No life is so long that its steps turn negative", "[schedule]") {
  for (const double time : {1e15, 1e18, 1e100, 1e308})
    for (const double step : {0.1, 1e-9, 5e-324})
      CHECK(NearestStep(time, step) >= 10'000'000'000'000'000);
}

}  // namespace
}  // namespace plsc
