#include "tests/runtime/vary/chi_square.h"

#include <catch2/catch.hpp>

namespace plsc::test {

TEST_CASE("The chi-square tail agrees with printed tables", "[chi_square]") {
  // Critical values of 5 %, 1 % and 0.1 %, printed to 3 decimals.
  struct Row {
    double x;
    int degrees;
    double tail;
  };
  for (const Row& row : std::vector<Row>{{3.841, 1, 0.05},
                                         {6.635, 1, 0.01},
                                         {9.488, 4, 0.05},
                                         {20.515, 5, 0.001},
                                         {30.144, 19, 0.05},
                                         {149.449, 100, 0.001}}) {
    CAPTURE(row.x, row.degrees);
    CHECK(ChiSquareTail(row.x, row.degrees) == Approx(row.tail).epsilon(2e-3));
  }
}

TEST_CASE("A comparison refuses what differs and accepts what does not",
          "[chi_square]") {
  const std::vector<int> quarters = {5010, 4979, 5033, 4978};
  CHECK(PValue(quarters, std::vector<double>{1, 1, 1, 1}) > 0.05);
  CHECK(PValue(quarters, std::vector<double>{1, 1, 1, 1.2}) < kSignificance);
  CHECK(PValue(quarters, std::vector<int>{498, 503, 501, 499}) > 0.05);
  CHECK(PValue(quarters, std::vector<int>{5500, 4979, 4543, 4978}) <
        kSignificance);
}

}  // namespace plsc::test
