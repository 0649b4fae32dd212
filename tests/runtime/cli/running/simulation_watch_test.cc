#include "runtime/cli/running/simulation_watch.h"

#include <catch2/catch.hpp>
#include <sstream>

#include "runtime/cli/running/interrupt.h"
#include "sim/simulate.h"
#include "tests/runtime/recording/recorded.h"

namespace plsc {
namespace {

TEST_CASE("progress of a life shows the rate and the time left",
          "[simulation_watch]") {
  cli::SimulationProgress progress{"tilted", 2, 2, 25, 50, 50, 100, 0};
  CHECK(cli::ProgressText(progress) == "season tilted (2 of 2)  25.0/50.0 s");
  progress.seconds = 0.5;
  CHECK(cli::ProgressText(progress) ==
        "season tilted (2 of 2)  25.0/50.0 s  150 x real time  0:00 left");
  progress.seconds = 300;  // 0.25 s of life a second
  CHECK(cli::ProgressText(progress) ==
        "season tilted (2 of 2)  25.0/50.0 s  0.25 x real time  1:40 left");
}

TEST_CASE("Ctrl-C ends a life that is watched", "[simulation_watch]") {
  Scenario scenario;
  scenario.seasons.resize(1);
  const cli::InterruptHandler handler;
  cli::SimulationWatch watch(scenario, nullptr, true);
  std::raise(SIGINT);
  const Lived lived =
      Live(test::SmallRobot(), {}, SimulationOptions{}, {}, &watch);
  CHECK(lived.trajectory.outcome == Outcome::kStopped);
  CHECK(watch.FinishSeason().samples() == 1);  // the start
}

TEST_CASE("a season that is done at once has no progress line",
          "[simulation_watch]") {
  Scenario scenario;
  scenario.seasons.resize(1);
  const cli::InterruptHandler handler;
  std::ostringstream terminal;
  cli::SimulationWatch watch(scenario, &terminal, false);
  SimulationOptions options;
  options.duration = 0.005;
  Live(test::SmallRobot(), {}, options, {}, &watch);
  CHECK(watch.FinishSeason().samples() == 0);
  CHECK(terminal.str().empty());
}

}  // namespace
}  // namespace plsc
