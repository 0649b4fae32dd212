#include "runtime/cli/running/progress.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace plsc {
namespace {

using cli::Pace;
using cli::ProgressText;

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

std::size_t Count(const std::string& text, char wanted) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), wanted));
}

/// A line with a clock that the test turns.
struct WatchedRun {
  explicit WatchedRun(bool is_terminal, int columns = 200)
      : line(out, is_terminal, 10) {
    line.SetWorld([this] { return now; }, [columns] { return columns; });
  }
  std::ostringstream out;
  double now = 0;
  cli::ProgressLine line;
};

TEST_CASE("progress shows how fast, how long, and the best", "[progress]") {
  CHECK(ProgressText(Half(), 10, Pace{2, 24.6, 0.127, 50}, 0) ==
        "generation 5/10  100/200 evaluations  2.0/s  0:50 left  "
        "24.6x real time  13 % looked up  1/2 busy  "
        "flat best 1.23  median 0.10  tilted best none  median none  cm/s");
}

TEST_CASE("progress shows penalties as penalties", "[progress]") {
  Progress progress = Half();
  progress.seasons = {{"flat", 0.0123, -0.1}, {"tilted", -0.1, {}}};
  CHECK(ProgressText(progress, 10, {}, 0) ==
        "generation 5/10  100/200 evaluations  1/2 busy  flat best 1.23  "
        "median penalty  tilted best penalty  median none  cm/s");
  progress.seasons = {{"flat", -0.1, {}}};
  CHECK(ProgressText(progress, 10, {}, 0) ==
        "generation 5/10  100/200 evaluations  1/2 busy  flat best penalty  "
        "median none");
}

TEST_CASE("progress before the first evaluation has no rate", "[progress]") {
  CHECK(ProgressText(Progress{}, 10, {}, 0) ==
        "generation 1/10  0/0 evaluations  0/0 busy");
}

TEST_CASE("progress leaves out what matters least until it fits",
          "[progress]") {
  Progress progress = Half();
  progress.seasons.push_back({"rough", 0.02, 0.01});
  const Pace pace = {2, 24.6, 0.127, 50};
  struct Row {
    int width;
    const char* expected;
  };
  const std::vector<Row> rows = {
      {141,
       "gen 5/10  100/200  2.0/s  0:50 left  24.6x real  13% cached  1/2 busy  "
       "flat 1.23  med 0.10  tilted none  med none  rough 2.00  med 1.00  "
       "cm/s"},
      {131,
       "gen 5/10  100/200  2.0/s  0:50 left  24.6x real  13% cached  flat 1.23 "
       " med 0.10  tilted none  med none  rough 2.00  med 1.00  cm/s"},
      {121,
       "gen 5/10  100/200  2.0/s  0:50 left  24.6x real  13% cached  flat 1.23 "
       " med 0.10  tilted none  med none  rough 2.00  cm/s"},
      {111,
       "gen 5/10  100/200  2.0/s  0:50 left  24.6x real  13% cached  flat 1.23 "
       " med 0.10  tilted none  rough 2.00  cm/s"},
      {99,
       "gen 5/10  100/200  2.0/s  0:50 left  24.6x real  13% cached  flat 1.23 "
       " med 0.10  tilted none  cm/s"},
      {86,
       "gen 5/10  100/200  2.0/s  0:50 left  24.6x real  13% cached  flat 1.23 "
       " med 0.10  cm/s"},
      {74,
       "gen 5/10  100/200  2.0/s  0:50 left  13% cached  flat 1.23  med 0.10  "
       "cm/s"},
      {62, "gen 5/10  100/200  2.0/s  0:50 left  flat 1.23  med 0.10  cm/s"},
      {52, "gen 5/10  100/200  2.0/s  0:50 left  flat 1.23  cm/s"},
      {43, "gen 5/10  2.0/s  0:50 left  flat 1.23  cm/s"},
      {26, "gen 5/10  2.0/s  0:50 left"},
      {19, "gen 5/10  0:50 left"},
      {12, "gen 5/10  0:"}};
  for (const Row& row : rows) {
    CAPTURE(row.width);
    CHECK(ProgressText(progress, 10, pace, row.width) == row.expected);
    CHECK(ProgressText(progress, 10, pace, row.width - 1) != row.expected);
  }
}

TEST_CASE("durations read as clocks do", "[progress]") {
  CHECK(cli::DurationText(7.4) == "0:07");
  CHECK(cli::DurationText(59.6) == "1:00");
  CHECK(cli::DurationText(760) == "12:40");
  CHECK(cli::DurationText(11100) == "3:05:00");
}

TEST_CASE("a log file gets a line a generation, and one a minute",
          "[progress]") {
  WatchedRun log(false);
  Progress progress = Half();
  log.line.Report(progress);
  CHECK(Count(log.out.str(), '\n') == 1);
  log.now = 59;
  log.line.Report(progress);
  log.line.Tick();
  CHECK(Count(log.out.str(), '\n') == 1);
  ++progress.generation;
  log.line.Report(progress);
  CHECK(Count(log.out.str(), '\n') == 2);
  // A generation that takes long, without and with news.
  log.now = 120;
  log.line.Tick();
  CHECK(Count(log.out.str(), '\n') == 3);
  log.now = 181;
  log.line.Report(progress);
  CHECK(Count(log.out.str(), '\n') == 4);
  // The end, once.
  progress.evaluations = progress.total;
  log.now = 182;
  log.line.Report(progress);
  log.line.Finish();
  log.line.Finish();
  CHECK(Count(log.out.str(), '\n') == 5);
  CHECK_THAT(log.out.str(), Catch::Contains("200/200"));
  CHECK(Count(log.out.str(), '\r') == 0);
}

TEST_CASE("a terminal gets one line, drawn again", "[progress]") {
  WatchedRun screen(true);
  Progress progress = Half();
  screen.line.Report(progress);
  screen.now = 0.1;
  screen.line.Report(progress);
  CHECK(Count(screen.out.str(), '\r') == 1);
  screen.now = 0.3;
  screen.line.Tick();
  CHECK(Count(screen.out.str(), '\r') == 2);
  progress.evaluations = progress.total;
  screen.line.Report(progress);
  screen.line.Finish();
  CHECK(Count(screen.out.str(), '\r') == 3);
  CHECK(Count(screen.out.str(), '\n') == 1);
}

TEST_CASE("a terminal's line never reaches its last column", "[progress]") {
  for (const int columns : {1, 20, 40, 80}) {
    CAPTURE(columns);
    WatchedRun screen(true, columns);
    screen.line.Report(Half());
    screen.now = 1;
    screen.line.Report(Progress{});
    std::istringstream drawn(screen.out.str());
    std::string line;
    while (std::getline(drawn, line, '\r'))
      CHECK(line.size() <= static_cast<std::size_t>(std::max(1, columns - 1)));
  }
}

TEST_CASE("a shorter line wipes the longer one", "[progress]") {
  WatchedRun screen(true);
  screen.line.Report(Half());
  const std::size_t longer = screen.out.str().size();
  screen.now = 1;
  screen.line.Report(Progress{});
  CHECK(screen.out.str().size() == 2 * longer);
}

TEST_CASE("a run that goes on does not count what was done before",
          "[progress]") {
  std::ostringstream out;
  cli::ProgressLine line(out, false, 10, 90);
  line.SetWorld([] { return 5.0; }, [] { return 80; });
  line.Report(Half());
  CHECK_THAT(out.str(), Catch::Contains("  2.0/s  0:50 left"));
}

TEST_CASE("without news there is nothing to show", "[progress]") {
  WatchedRun screen(true);
  screen.line.Tick();
  screen.line.Finish();
  CHECK(screen.out.str().empty());
}

TEST_CASE("the width is what COLUMNS says where no terminal does",
          "[progress]") {
  // Tests run with standard error in a pipe or a file, or on a terminal.
  setenv("COLUMNS", "123", 1);
  const int width = cli::TerminalWidth();
  unsetenv("COLUMNS");
  CHECK((width == 123 || width == cli::TerminalWidth()));
  CHECK(cli::TerminalWidth() > 0);
}

}  // namespace
}  // namespace plsc
