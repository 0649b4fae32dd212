#include "runtime/report/quantiles.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace plsc {

TEST_CASE("Quantiles are R's of type 7", "[quantiles]") {
  // quantile(c(0.1, 0.35, 0.4, 0.8, 2, 9.5), share) of R 4.2.2
  const std::vector<double> values{0.1, 0.35, 0.4, 0.8, 2, 9.5};
  struct Row {
    double share;
    double expected;
  };
  for (const Row& row :
       {Row{0, 0.1}, Row{0.1, 0.225}, Row{0.25, 0.3625}, Row{0.5, 0.6},
        Row{0.6, 0.8}, Row{0.75, 1.7}, Row{1, 9.5}}) {
    CAPTURE(row.share);
    CHECK(Quantile(values, row.share) == Approx(row.expected).epsilon(1e-14));
  }
  CHECK(Quantile({3}, 0.25) == 3);
}

TEST_CASE("Quartiles take values in any order", "[quantiles]") {
  const Quartiles quartiles = QuartilesOf({4, 1, 3, 2});
  CHECK(quartiles.low == 1.75);
  CHECK(quartiles.median == 2.5);
  CHECK(quartiles.high == 3.25);
  CHECK(std::isnan(QuartilesOf({}).median));
}

TEST_CASE("Whiskers end at values, and outliers lie beyond", "[quantiles]") {
  // Box 2 to 4, so that whiskers reach to -1 and 7 at most.
  const BoxPlot box = BoxPlotOf({20, 1, 2, 3, 4});
  CHECK(box.quartiles.low == 2);
  CHECK(box.quartiles.high == 4);
  CHECK(box.low_whisker == 1);
  CHECK(box.high_whisker == 4);
  CHECK(box.outliers == std::vector<double>{20});
  CHECK(box.mean == 6);

  const BoxPlot edge = BoxPlotOf({-1, 2, 3, 4, 7});
  CHECK(edge.low_whisker == -1);
  CHECK(edge.high_whisker == 7);
  CHECK(edge.outliers.empty());

  const BoxPlot single = BoxPlotOf({5});
  CHECK(single.low_whisker == 5);
  CHECK(single.high_whisker == 5);
  CHECK(single.mean == 5);
}

}  // namespace plsc
