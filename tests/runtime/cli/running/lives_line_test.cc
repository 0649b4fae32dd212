#include "runtime/cli/running/lives_line.h"

#include <catch2/catch.hpp>
#include <sstream>

namespace plsc {
namespace {

struct DrawnLives {
  std::ostringstream out;
  double now = 0;
  int width = 80;
  cli::LivesLine line;

  explicit DrawnLives(bool is_terminal, bool is_quiet = false)
      : line(out, is_terminal, is_quiet) {
    line.SetWorld([this] { return now; }, [this] { return width; });
  }
  void Report(const cli::LivesProgress& progress, double at) {
    now = at;
    line.Report(progress);
  }
};

TEST_CASE("the line tells how fast lives go and when all runs are through",
          "[lives_line]") {
  DrawnLives drawn(true);
  drawn.Report({0, 2, "plastic/1", 50, 100}, 10);
  // 50 lives of this run and 100 of the next, at 5 a second.
  CHECK(drawn.out.str() ==
        "\rrun 1/2 plastic/1  50/100 lives  5.0/s  0:30 left");
  drawn.Report({1, 2, "plastic/2", 50, 100}, 20);
  CHECK(drawn.out.str().ends_with(
      "run 2/2 plastic/2  50/100 lives  5.0/s  0:10 left"));
}

TEST_CASE("it is drawn a few times a second, and a line a minute in files",
          "[lives_line]") {
  DrawnLives drawn(true);
  drawn.Report({0, 1, "r", 1, 9}, 1);
  const std::string first = drawn.out.str();
  drawn.Report({0, 1, "r", 2, 9}, 1.1);
  CHECK(drawn.out.str() == first);
  drawn.Report({0, 1, "r", 3, 9}, 1.3);
  CHECK(drawn.out.str() != first);

  DrawnLives filed(false);
  filed.Report({0, 1, "r", 0, 9}, 0);
  filed.Report({0, 1, "r", 1, 9}, 59);
  CHECK(filed.out.str() == "r  0/9 lives\n");
  filed.Report({0, 1, "r", 6, 9}, 60);
  CHECK(filed.out.str() == "r  0/9 lives\nr  6/9 lives  0.1/s  0:30 left\n");
}

TEST_CASE("it fits its terminal and is gone at the end", "[lives_line]") {
  DrawnLives drawn(true);
  drawn.width = 12;
  drawn.Report({0, 2, "plastic/1", 50, 100}, 10);
  CHECK(drawn.out.str() == "\rrun 1/2 pla");
  drawn.line.Finish();
  CHECK(drawn.out.str().ends_with("\r" + std::string(11, ' ') + "\r"));
}

TEST_CASE("who wants quiet gets it", "[lives_line]") {
  DrawnLives drawn(true, true);
  drawn.Report({0, 2, "plastic/1", 50, 100}, 10);
  drawn.line.Finish();
  CHECK(drawn.out.str().empty());
}

}  // namespace
}  // namespace plsc
