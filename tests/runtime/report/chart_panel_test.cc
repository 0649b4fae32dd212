#include "runtime/report/chart_panel.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace plsc {

TEST_CASE("Ticks are round numbers within the range", "[chart_panel]") {
  const auto check = [](double low, double high, int count,
                        const std::vector<double>& expected) {
    const std::vector<double> ticks = RoundTicks(low, high, count);
    REQUIRE(ticks.size() == expected.size());
    for (std::size_t i = 0; i < ticks.size(); ++i)
      CHECK(ticks[i] == Approx(expected[i]).margin(1e-12));
  };
  check(0, 1, 5, {0, 0.2, 0.4, 0.6, 0.8, 1});
  check(-3, 4.1, 5, {-2, 0, 2, 4});
  check(0, 199, 4, {0, 50, 100, 150});
  check(7.3, 7.9, 4, {7.4, 7.6, 7.8});
  check(1, 1, 5, {});
  check(NAN, 1, 5, {});
}

TEST_CASE("A scale has all values within, also if they are one, or none",
          "[chart_panel]") {
  const ChartScale scale = ScaleOf({2, NAN, 4, INFINITY}, 100, 0);
  CHECK(scale(4) > 0);
  CHECK(scale(2) < 100);
  CHECK(scale(3) == Approx(50));
  for (const double only : {0.0, -3.0, 1e-9}) {
    const ChartScale one = ScaleOf({only, only}, 100, 0);
    CHECK(one(only) == Approx(50));
  }
  CHECK(ScaleOf({}, 100, 0)(0.5) == Approx(50));
}

TEST_CASE("A grid has a line and a label a tick", "[chart_panel]") {
  const std::string svg = ChartGrid({0, 0.7, 100, 0}, 40, 300);
  for (const char* label : {">0<", ">0.2<", ">0.4<", ">0.6<"})
    CHECK(svg.find(label) != std::string::npos);
  CHECK(svg.find("M40.0 100.0H300.0") != std::string::npos);
}

}  // namespace plsc
