#include "runtime/cli/progress.h"

#include <catch2/catch.hpp>
#include <sstream>

namespace plsc {
namespace {

Progress Half() {
  Progress progress;
  progress.generation = 4;
  progress.evaluations = 100;
  progress.total = 200;
  progress.workers = 2;
  progress.busy_workers = 1;
  progress.seasons = {{"flat", 0.0123, 0.001}, {"tilted", std::nullopt, {}}};
  return progress;
}

TEST_CASE("progress shows rate, time left and the best", "[progress]") {
  CHECK(cli::ProgressText(Half(), 10, 50) ==
        "generation 5/10  evaluations 100/200  2.0/s  0:50 left  1/2 busy  "
        "best flat 1.23 tilted none cm/s");
}

TEST_CASE("progress before the first evaluation has no rate", "[progress]") {
  CHECK(cli::ProgressText(Progress{}, 10, 0) ==
        "generation 1/10  evaluations 0/0  0/0 busy");
}

TEST_CASE("durations read as clocks do", "[progress]") {
  CHECK(cli::DurationText(7.4) == "0:07");
  CHECK(cli::DurationText(59.6) == "1:00");
  CHECK(cli::DurationText(760) == "12:40");
  CHECK(cli::DurationText(11100) == "3:05:00");
}

TEST_CASE("a log file gets a line a generation, a terminal one line",
          "[progress]") {
  Progress progress = Half();
  std::ostringstream file;
  cli::ProgressLine log(file, false, 10);
  log.Show(progress);
  log.Show(progress);
  ++progress.generation;
  log.Show(progress);
  log.Finish();
  const std::string lines = file.str();
  CHECK(std::count(lines.begin(), lines.end(), '\n') == 2);

  std::ostringstream screen;
  cli::ProgressLine line(screen, true, 10);
  line.Show(progress);
  progress.evaluations = progress.total;
  line.Show(progress);
  line.Finish();
  const std::string drawn = screen.str();
  CHECK(std::count(drawn.begin(), drawn.end(), '\r') == 2);
  CHECK(std::count(drawn.begin(), drawn.end(), '\n') == 1);
}

}  // namespace
}  // namespace plsc
