#include "runtime/report/holm.h"

#include <catch2/catch.hpp>

#include "tests/runtime/report/r_rows.h"

namespace plsc {

TEST_CASE("Holm's correction is that of R's p.adjust", "[holm]") {
  for (const test::RRow& row : test::RRows("holm")) {
    // Those that could not be tested count, wherever they stand.
    std::vector<std::optional<double>> family(
        static_cast<std::size_t>(row.y[0]) - row.x.size());
    const std::size_t missing = family.size();
    family.insert(family.end(), row.x.begin(), row.x.end());
    const auto adjusted = HolmAdjusted(family);
    REQUIRE(adjusted.size() == family.size());
    for (std::size_t i = 0; i < missing; ++i) CHECK_FALSE(adjusted[i]);
    for (std::size_t i = 0; i < row.x.size(); ++i)
      CHECK(*adjusted[missing + i] == Approx(row.numbers[i]).epsilon(1e-14));
  }
  CHECK(HolmAdjusted({}).empty());
}

}  // namespace plsc
